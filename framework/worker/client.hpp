// SPDX-License-Identifier: MIT
// The client of a worker. It asks one implementation, which runs in a process of its own, and
// survives whatever that process does.
#pragma once

#include "formulas/table.hpp"
#include "scene/run/run_scene.hpp"
#include "worker/failure.hpp"
#include "worker/session.hpp"

#include <map>

namespace rigor {

/// Tag and name of a formula: "A4.10 apply_impulse".
std::string subject_of(FormulaIndex formula);

/// One implementation of the formulas, which several processes may run one after the other. A
/// request that fails ends its process, and the next request gets a fresh one. Every request
/// returns in bounded time.
///
/// A worker must be used from one thread only: a process dies with the thread that started it.
class Worker {
public:
    using Start = Moment;

    /// @param oracle  is asked how long a slow request may take; it must outlive this worker
    explicit Worker(std::filesystem::path executable, Limits limits = {}, Worker* oracle = nullptr);

    /// The encoded result of a formula on encoded arguments.
    /// @param largest  largest size of an encoded result [bytes]
    /// A formula that has twice not returned in time is not called again.
    /// @throws NotImplemented, FormulaMissing, WorkerFailure
    Bytes call(FormulaIndex formula, std::span<const std::byte> arguments, std::size_t largest);

    /// Runs a scene and passes its trajectory to `sink` as it comes, up to the failure if there is
    /// one. The bytes have not been checked.
    /// @param threads  number of threads for the reference; other implementations use one
    /// @throws NotImplemented, WorkerFailure, NotFinite, what `sink` throws
    void run_scene(const std::string& scene_text, const std::string& scene_name, Record record,
                   const ByteSink& sink, int threads = 1);

    /// The states after `steps` time steps from each of `starts`. They are finite.
    /// @throws NotImplemented, WorkerFailure, NotFinite
    std::vector<std::vector<RigidState>> advance(const std::string& scene_text,
                                                 const std::string& scene_name,
                                                 const std::vector<Start>& starts, int steps);

    /// Ends the process, so that the next request starts a fresh one.
    void renew();

    /// The beginning of what the implementation printed since the last call of this function, made
    /// printable.
    std::string take_output();

    /// Starts the process if there is none and waits until it is ready. Requests do so themselves.
    /// @throws WorkerFailure
    void start();

    const std::filesystem::path& executable() const { return executable_; }

private:
    friend class SceneAnswers;
    using Seconds = Allowance::Seconds;
    using States = std::vector<std::vector<RigidState>>;

    Bytes ask(const Question& question, Allowance& allowance);
    [[noreturn]] void refuse(const Reply& reply);
    bool is_hopeless(FormulaIndex formula) const;
    void require_hope(FormulaIndex formula) const;
    void count_time(const Question& question, Seconds waited);
    Reply exchange(const Question& question, Allowance& allowance);
    Seconds duration(Question question);
    States advance_some(const std::string& scene_text, const std::string& scene_name,
                        std::span<const Start> starts, int steps);
    [[noreturn]] void fail(const Broken& broken, const ByteSink* sink);

    std::filesystem::path executable_;
    Limits limits_;
    Worker* oracle_;
    std::unique_ptr<Session> session_;
    std::string subject_; // what the current request asks for
    std::string output_;
    int failed_starts_ = 0;
    std::optional<WorkerFailure> start_failure_;
    std::map<FormulaIndex, int> timed_out_; // for each formula, how often it did not return
    /// See Limits::all_calls: the time of all calls, and of those after the free part, here and by
    /// the oracle.
    Seconds all_calls_{}, paid_calls_{}, paid_by_oracle_{};
    Seconds all_scenes_{}; // see Limits::all_scenes
};

} // namespace rigor
