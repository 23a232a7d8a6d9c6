// SPDX-License-Identifier: MIT
// Runs a scene with an implementation's formulas, such that the implementation cannot fake the
// motion: the engine whose states count runs in the client. The worker runs the same scene ahead of
// the client and streams only the answer of each formula, in the order of the calls. The client's
// engine takes these answers instead of asking for each, which would take far longer. Both engines
// get the same answers and use no faster forms of the formulas, so they make the same calls. If a
// worker streams other answers than those of its formulas, they only count as wrong answers of its
// formulas.
//
// Where the reference answers a formula instead of the implementation, the client gives the worker
// this answer: the worker waits at such a call until the client has come to the same call and has
// sent the answer.
#pragma once

#include "worker/client.hpp"

#include <exception>

namespace rigor {

class SceneAnswers {
public:
    /// Starts the run in the worker, which must outlive this object and gets no other request
    /// meanwhile.
    /// @param scene_name  for messages
    /// @param payload     the payload of the request: the scene's text and name, encoded
    /// @param every_step  whether every time step is recorded; to record a deformable solid, the
    ///                    engine calls formulas too
    /// @param given       the formulas whose answers the worker gets by `give`
    SceneAnswers(Worker& worker, const std::string& scene_name, Bytes payload, bool every_step,
                 const FormulaSet& given = {});
    /// Ends the worker's process, unless both the worker and the client's engine have come to the
    /// end of the scene.
    ~SceneAnswers();
    SceneAnswers(const SceneAnswers&) = delete;
    SceneAnswers& operator=(const SceneAnswers&) = delete;

    /// The encoded answer of the formula that the engine calls now, valid until the next call.
    /// @param largest  largest size of the answer [bytes]
    /// @throws NotImplemented, FormulaMissing, WorkerFailure
    std::span<const std::byte> next(FormulaIndex formula, std::size_t largest);

    /// Gives the worker the encoded answer of a formula that the engine has just called.
    /// @throws WorkerFailure
    void give(FormulaIndex formula, std::span<const std::byte> answer);

private:
    using Seconds = Allowance::Seconds;

    void require(std::size_t size, FormulaIndex formula);
    Bytes await_part(FormulaIndex formula);
    void count_wait(FormulaIndex formula, Seconds time);
    void count_time(Seconds time);
    bool takes_too_long();
    std::string too_long() const;
    const Pace& reference_pace();
    Seconds time_for_answers();
    std::string subject(FormulaIndex formula) const;
    [[noreturn]] void say_why_it_ended(FormulaIndex formula);
    [[noreturn]] void fail_as_given_up(FormulaIndex formula);
    [[noreturn]] void fail(const Broken& broken, FormulaIndex formula);

    Worker& worker_;
    std::string scene_name_;
    Bytes payload_;
    Question question_;
    Bytes part_;         // received bytes of the stream
    std::size_t at_ = 0; // how much of `part_` was taken [bytes]
    // The bytes taken before `part_`, plus the bytes given to the worker.
    std::size_t taken_before_ = 0;
    int exceptions_ = std::uncaught_exceptions(); // uncaught exceptions when the scene began
    Seconds waited_{};                            // time of all waits so far
    std::array<Seconds, formula_count> waited_for_{};
    std::optional<Pace> reference_pace_;
};

} // namespace rigor
