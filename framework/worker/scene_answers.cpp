// SPDX-License-Identifier: MIT
// Takes a stream of answers apart. Each answer has a header with its formula and its size. If the
// engine calls another formula than the one in the next header, or if the worker's run has ended,
// the call has no answer. The failure then names the formula, as for a call outside of scenes.
#include "worker/scene_answers.hpp"

#include "worker/protocol/streamed_answer.hpp"
#include "worker/protocol/wire.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace rigor {

SceneAnswers::SceneAnswers(Worker& worker, const std::string& scene_name, Bytes payload,
                           bool every_step, const FormulaSet& given)
    : worker_(worker), scene_name_(scene_name), payload_(std::move(payload))
{
    SceneOptions options;
    options.streams_answers = true;
    options.every_step = every_step;
    question_ = {Request::run_scene, options.packed(), payload_};
    question_.given = given;
    // The stream may have any length, since it is not stored.
    question_.longest_stream = std::numeric_limits<std::size_t>::max();
    worker_.subject_ = "scene " + scene_name;
    worker_.start();
    try {
        worker_.session_->begin(question_);
    } catch (const Broken& broken) {
        worker_.fail(broken, nullptr);
    }
}

SceneAnswers::~SceneAnswers()
{
    if (!worker_.session_) return; // the worker has failed, so its process is gone
    const bool has_engine_failed = std::uncaught_exceptions() > exceptions_;
    try {
        Allowance allowance{Seconds(1)};
        if (!has_engine_failed && at_ == part_.size() &&
            worker_.session_->next_part(allowance).empty())
            return;
    } catch (...) {
        // The engine needs no more answers, so this failure does not matter.
    }
    worker_.renew();
}

std::span<const std::byte> SceneAnswers::next(FormulaIndex formula, std::size_t largest)
{
    if (worker_.budget_.ends_scenes(formula)) fail_as_given_up(formula);
    StreamedAnswer header{};
    require(sizeof header, formula);
    std::memcpy(&header, part_.data() + at_, sizeof header);
    // An answer in a scene is never longer than the answer to a single call. Without this check, a
    // worker could announce a size that fills this process's memory.
    if (header.formula != static_cast<std::uint32_t>(formula) ||
        header.size > std::min(largest, Channel::capacity))
        fail({WorkerFailure::malformed, "sent no answer: it is out of step with the scene"},
             formula);
    require(sizeof header + header.size, formula);
    const std::span answer(part_.data() + at_ + sizeof header, header.size);
    at_ += sizeof header + header.size;
    return answer;
}

void SceneAnswers::give(FormulaIndex formula, std::span<const std::byte> answer)
{
    const auto fail_scene = [this](const Broken& broken) {
        worker_.subject_ = "scene " + scene_name_;
        worker_.fail(broken, nullptr);
    };
    Allowance allowance{worker_.budget_.floor_of_call()};
    try {
        worker_.session_->give(formula, answer, allowance);
    } catch (const Broken& broken) {
        count_time(allowance.waited);
        fail_scene(broken);
    }
    taken_before_ += sizeof(StreamedAnswer) + answer.size();
    if (allowance.waited.count() == 0) return;
    count_time(allowance.waited);
    if (takes_too_long()) fail_scene({WorkerFailure::timed_out, too_long()});
}

void SceneAnswers::fail_as_given_up(FormulaIndex formula)
{
    worker_.subject_ = subject(formula);
    worker_.fail({WorkerFailure::timed_out, worker_.budget_.why_given_up(formula)}, nullptr);
}

/// Waits until the next `size` bytes of the stream are in `part_`.
void SceneAnswers::require(std::size_t size, FormulaIndex formula)
{
    while (part_.size() - at_ < size) {
        const Bytes more = await_part(formula);
        if (more.empty()) say_why_it_ended(formula);
        taken_before_ += at_;
        part_.erase(part_.begin(), part_.begin() + static_cast<std::ptrdiff_t>(at_));
        part_.insert(part_.end(), more.begin(), more.end());
        at_ = 0;
    }
}

Bytes SceneAnswers::await_part(FormulaIndex formula)
{
    const TimeBudget& budget = worker_.budget_;
    Allowance allowance{budget.floor_of_wait(formula), worker_.limits_.multiple};
    if (worker_.oracle_ && !budget.is_given_up(formula))
        allowance.reference = [this] { return reference_pace().longest_wait; };
    try {
        Bytes part = worker_.session_->next_part(allowance);
        count_wait(formula, allowance.waited);
        return part;
    } catch (const Broken& broken) {
        worker_.budget_.failed(formula, allowance.waited, broken.cause == WorkerFailure::timed_out);
        fail(broken, formula);
    }
}

/// Counts the time of a wait. Ends the scene if its answers so far took too long. The formula with
/// the longest total wait is then reported as the cause.
void SceneAnswers::count_wait(FormulaIndex formula, Seconds time)
{
    count_time(time);
    waited_for_[static_cast<unsigned>(formula)] += time;
    if (!takes_too_long()) return;
    const auto most = std::max_element(waited_for_.begin(), waited_for_.end());
    const FormulaIndex slowest{static_cast<unsigned>(most - waited_for_.begin())};
    worker_.budget_.failed(slowest, Seconds(0), true);
    fail({WorkerFailure::timed_out, too_long()}, slowest);
}

void SceneAnswers::count_time(Seconds time)
{
    waited_ += time;
    worker_.budget_.waited_in_scene(time);
}

bool SceneAnswers::takes_too_long()
{
    return waited_ > worker_.budget_.floor_of_scene() && waited_ > time_for_answers();
}

std::string SceneAnswers::too_long() const
{
    return fmt::format("did not return: the scene takes more than {:.3g} s", waited_.count());
}

const Pace& SceneAnswers::reference_pace()
{
    if (reference_pace_) return *reference_pace_;
    Question whole = question_; // for the oracle, which answers all formulas by itself
    whole.given.reset();
    reference_pace_ = worker_.oracle_ ? worker_.oracle_->pace(whole) : Pace();
    return *reference_pace_;
}

/// How long the answers so far may have taken: the time that the reference takes for as many bytes,
/// plus its longest wait between two parts of the stream, both times `Limits::multiple`.
SceneAnswers::Seconds SceneAnswers::time_for_answers()
{
    const Pace& pace = reference_pace();
    if (pace.size == 0) return Seconds(0);
    const double part = static_cast<double>(taken_before_ + at_) / static_cast<double>(pace.size);
    return worker_.limits_.multiple * (pace.longest_wait + std::min(part, 1.0) * pace.whole);
}

std::string SceneAnswers::subject(FormulaIndex formula) const
{
    return fmt::format("{} in scene {}", subject_of(formula), scene_name_);
}

void SceneAnswers::say_why_it_ended(FormulaIndex formula)
{
    try {
        const Reply reply = worker_.session_->take_reply();
        worker_.subject_ = subject(formula);
        if (reply.status != ReplyStatus::done && reply.status != ReplyStatus::not_finite)
            worker_.refuse(reply);
    } catch (const Broken& broken) {
        fail(broken, formula);
    }
    fail({WorkerFailure::malformed, "sent no answer: its run of the scene is over"}, formula);
}

void SceneAnswers::fail(const Broken& broken, FormulaIndex formula)
{
    worker_.subject_ = subject(formula);
    worker_.budget_.scene_failed(formula);
    worker_.fail(broken, nullptr);
}

} // namespace rigor
