// SPDX-License-Identifier: MIT
// The client of a worker process. It sends requests to one implementation of the formulas, which
// runs in the worker process. A failure of that process does not end the client.
#pragma once

#include "formulas/table.hpp"
#include "scene/run/run_scene.hpp"
#include "worker/failure.hpp"
#include "worker/session.hpp"
#include "worker/time_budget.hpp"

namespace rigor {

/// Tag and name of a formula: "A4.10 apply_impulse".
const std::string& subject_of(FormulaIndex formula);

/// How fast an implementation streams the answers of a scene.
struct Pace {
    // The time for all answers, and the longest wait between two parts of the stream.
    std::chrono::duration<double> whole{}, longest_wait{};
    std::size_t size = 0; // the size of all answers together [bytes]
};

/// One implementation of the formulas, which several processes may run one after the other. If a
/// process gives no answer to a request (`WorkerFailure`), it is ended, and the next request gets a
/// fresh one. Every request returns in bounded time.
///
/// A worker must be used from one thread only: a process dies with the thread that started it.
class Worker {
public:
    using Start = Moment;

    /// @param oracle  the worker of the reference, which gets each slow request too, to measure how
    ///                long the reference takes; it must outlive this worker
    explicit Worker(std::filesystem::path executable, Limits limits = {}, Worker* oracle = nullptr);

    /// The encoded result of a formula on encoded arguments, valid until the next request.
    /// A formula that the `TimeBudget` has given up is not called: the request fails at once.
    /// @param largest  largest size of an encoded result [bytes]
    /// @throws NotImplemented, FormulaMissing, WorkerFailure
    const Bytes& call(FormulaIndex formula, std::span<const std::byte> arguments,
                      std::size_t largest);

    /// Runs a scene and passes its trajectory to `sink` as it arrives. If the run fails, `sink`
    /// gets the bytes before the failure. The bytes have not been checked.
    /// @param threads  number of threads for the reference; other implementations use one
    /// @throws NotImplemented, FormulaMissing, WorkerFailure, NotFinite, what `sink` throws
    void run_scene(const std::string& scene_text, const std::string& scene_name, Record record,
                   const ByteSink& sink, int threads = 1);

    /// The states after `steps` time steps from each of `starts`. All their numbers are finite.
    /// @throws NotImplemented, FormulaMissing, WorkerFailure, NotFinite
    std::vector<std::vector<RigidState>> advance(const std::string& scene_text,
                                                 const std::string& scene_name,
                                                 const std::vector<Start>& starts, int steps);

    /// Ends the process, so that the next request starts a fresh one.
    void renew();

    /// The beginning of what the implementation printed since the last call of this function, made
    /// printable. What it printed before a `WorkerFailure` is in that exception instead.
    std::string take_output();

    /// Starts the process if there is none and waits until it is ready. Each request does this by
    /// itself. After two failed starts in a row no further start is tried: the second failure is
    /// thrown again.
    /// @throws WorkerFailure
    void start();

    const std::filesystem::path& executable() const { return executable_; }

    TimeBudget& budget() { return budget_; }
    /// Begins the budget again, see `TimeBudget::begin_again`.
    void begin_budget_again(std::chrono::duration<double> budget);

private:
    friend class SceneAnswers;
    using Seconds = Allowance::Seconds;
    using States = std::vector<std::vector<RigidState>>;

    const Bytes& ask(const Question& question, Allowance& allowance);
    [[noreturn]] void refuse(const Reply& reply);
    const Reply& exchange(const Question& question, Allowance& allowance);
    class Uncounted;
    Seconds ran() const;
    Seconds duration(Question question);
    Pace pace(const Question& question);
    States advance_some(const std::string& scene_text, const std::string& scene_name,
                        std::span<const Start> starts, int steps);
    [[noreturn]] void fail(const Broken& broken, const ByteSink* sink);
    [[noreturn]] void fail_to_start(Broken broken, Seconds limit);

    std::filesystem::path executable_;
    Limits limits_;
    Worker* oracle_;
    std::unique_ptr<Session> session_;
    /// The previous process, which may still be ending, and a spare process for the next fresh
    /// start. The sandbox of the spare process is prepared; its program waits for
    /// `Confined::await_start`, or already runs if the sandbox has no listener. A spare process is
    /// made only after the first `renew`, because more calls of `renew` are then likely.
    std::unique_ptr<Session> ending_, spare_;
    std::string subject_; // what the current request is about, for messages of failures
    std::string output_;
    int failed_starts_ = 0;
    std::optional<WorkerFailure> start_failure_;
    TimeBudget budget_;
    /// The time on a processor of the processes that have ended, minus the time that does not count
    /// (`Uncounted`), and minus what the running process had used when the budget began again. So
    /// it may be negative [s].
    Seconds ended_ran_{};
};

} // namespace rigor
