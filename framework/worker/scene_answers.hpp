// SPDX-License-Identifier: MIT
// A scene with an implementation's formulas, whose motion the implementation cannot make up: the
// engine runs in the client. The worker runs the same scene ahead of it, and streams only the
// answer of each formula in the order of the calls; the client's engine takes these instead of
// asking for each, which would take far longer. Both engines are the same code and get the same
// answers, so they call the same formulas. A worker that streams something else has only given
// wrong answers.
//
// Some answers may be given to the worker instead, those of the reference: it waits at each until
// the client has come to the same call and has sent the answer.
#pragma once

#include "worker/client.hpp"

#include <exception>

namespace rigor {

class SceneAnswers {
public:
    /// Starts the run in the worker, which must outlive this object and gets no other request.
    /// @param scene_name  for messages
    /// @param kind        run_scene or advance
    /// @param payload     as `kind` expects it
    /// @param every_step  whether every step is recorded: a record of a solid calls formulas
    /// @param given       the formulas that `give` answers
    SceneAnswers(Worker& worker, const std::string& scene_name, Request kind, Bytes payload,
                 bool every_step, const FormulaSet& given = {});
    /// Ends the worker's process, unless it is done with the scene too.
    ~SceneAnswers();
    SceneAnswers(const SceneAnswers&) = delete;
    SceneAnswers& operator=(const SceneAnswers&) = delete;

    /// The encoded answer of the formula that the engine calls now, valid until the next call.
    /// @param largest  largest size of the answer [bytes]
    /// @throws NotImplemented, FormulaMissing, WorkerFailure
    std::span<const std::byte> next(FormulaIndex formula, std::size_t largest);

    /// Gives the worker the encoded answer of a formula that the engine has called now.
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
    Bytes part_;                   // the part of the stream that has come last
    std::size_t at_ = 0;           // how much of it was taken
    std::size_t taken_before_ = 0; // the size of the parts before that one, and of what was given
    int exceptions_ = std::uncaught_exceptions(); // when the scene began
    Seconds waited_{};                            // for all answers so far
    std::array<Seconds, formula_count> waited_for_{};
    std::optional<Pace> reference_pace_;
};

} // namespace rigor
