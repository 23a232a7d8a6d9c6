// SPDX-License-Identifier: MIT
// The client of a worker: asks one implementation, in its own process, and survives whatever it
// does.
#pragma once

#include "formulas/table.hpp"
#include "scene/run/run_scene.hpp"
#include "worker/failure.hpp"
#include "worker/session.hpp"

namespace rigor {

/// "A4.10 apply_impulse"
std::string subject_of(FormulaIndex formula);

/// One implementation of the formulas, whatever becomes of the processes that run it. A request
/// that fails ends its process; the next one gets a fresh process. Every request returns in bounded
/// time.
///
/// Not for several threads at once. A process dies with the thread that started it: use a worker
/// from one thread.
class Worker {
public:
    using Start = Moment;

    /// @param oracle  asked how long a slow request may take; outlives this
    explicit Worker(std::filesystem::path executable, Limits limits = {}, Worker* oracle = nullptr);

    /// The encoded result of a formula on encoded arguments.
    /// @param largest  bytes the encoding of a result can have
    /// @throws NotImplemented, WorkerFailure
    Bytes call(FormulaIndex formula, std::span<const std::byte> arguments, std::size_t largest);

    /// Runs a scene and hands on its trajectory as it comes, up to the failure if it fails. Nothing
    /// of it has been checked.
    /// @param threads  that the reference may use; formulas of others run on one
    /// @throws NotImplemented, WorkerFailure, NotFinite, what `sink` throws
    void run_scene(const std::string& scene_text, const std::string& scene_name, Record record,
                   const ByteSink& sink, int threads = 1);

    /// The states that `steps` time steps lead to from each of `starts`, finite.
    /// @throws NotImplemented, WorkerFailure, NotFinite
    std::vector<std::vector<RigidState>> advance(const std::string& scene_text,
                                                 const std::string& scene_name,
                                                 const std::vector<Start>& starts, int steps);

    /// Ends the process: the next request starts from a clean one.
    void renew();

    /// The beginning of what the implementation printed since the last call of this, made
    /// printable.
    std::string take_output();

    /// Starts the process if there is none, and waits until it is ready. Requests do so themselves.
    /// @throws WorkerFailure
    void start();

    const std::filesystem::path& executable() const { return executable_; }

private:
    using Seconds = Allowance::Seconds;
    using States = std::vector<std::vector<RigidState>>;

    Bytes ask(const Question& question, Seconds floor);
    Reply exchange(const Question& question, Allowance& allowance);
    Seconds duration(Question question);
    States advance_some(const std::string& scene_text, const std::string& scene_name,
                        std::span<const Start> starts, int steps);
    [[noreturn]] void fail(const Broken& broken, const ByteSink* sink);

    std::filesystem::path executable_;
    Limits limits_;
    Worker* oracle_;
    std::unique_ptr<Session> session_;
    std::string subject_; // what the request under way asks
    std::string output_;
    int failed_starts_ = 0;
    std::optional<WorkerFailure> start_failure_;
};

} // namespace rigor
