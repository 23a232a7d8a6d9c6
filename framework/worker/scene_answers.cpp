// SPDX-License-Identifier: MIT
// Takes a stream of answers apart. Each has a header with the formula and the size. If the formula
// is not the one that the engine calls, or if the run ended before, the call of this formula has no
// answer: the failure names the formula, as that of a single call does.
#include "worker/scene_answers.hpp"

#include "worker/protocol/streamed_answer.hpp"
#include "worker/protocol/wire.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace rigor {

SceneAnswers::SceneAnswers(Worker& worker, const std::string& scene_name, Request kind,
                           Bytes payload, bool every_step)
    : worker_(worker), scene_name_(scene_name), payload_(std::move(payload))
{
    SceneOptions options;
    options.streams_answers = true;
    options.every_step = every_step;
    question_ = {kind, options.packed(), payload_};
    question_.longest_stream = std::numeric_limits<std::size_t>::max(); // nothing of it is kept
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
    if (!worker_.session_) return; // it has failed
    try {
        Allowance allowance{Seconds(1)};
        if (at_ == part_.size() && worker_.session_->next_part(allowance).empty()) return;
    } catch (...) {
        // The engine needs no more answers, so this failure does not matter.
    }
    worker_.renew();
}

std::span<const std::byte> SceneAnswers::next(FormulaIndex formula, std::size_t largest)
{
    StreamedAnswer header{};
    require(sizeof header, formula);
    std::memcpy(&header, part_.data() + at_, sizeof header);
    // A single answer is no longer in a scene than alone. So the size that a worker announces does
    // not fill this process's memory.
    if (header.formula != static_cast<std::uint32_t>(formula) ||
        header.size > std::min(largest, Channel::capacity))
        fail({WorkerFailure::malformed, "sent no answer: it is out of step with the scene"},
             formula);
    require(sizeof header + header.size, formula);
    const std::span answer(part_.data() + at_ + sizeof header, header.size);
    at_ += sizeof header + header.size;
    return answer;
}

/// Waits until this many bytes are there.
void SceneAnswers::require(std::size_t size, FormulaIndex formula)
{
    while (part_.size() - at_ < size) {
        const Bytes more = await_part(formula);
        if (more.empty()) say_why_it_ended(formula);
        part_.erase(part_.begin(), part_.begin() + static_cast<std::ptrdiff_t>(at_));
        part_.insert(part_.end(), more.begin(), more.end());
        at_ = 0;
    }
}

Bytes SceneAnswers::await_part(FormulaIndex formula)
{
    const Limits& limits = worker_.limits_;
    Allowance allowance{limits.call, limits.multiple};
    if (worker_.is_hopeless(formula))
        allowance.limit /= 10; // it may return here, but is not waited for as long again
    else if (worker_.oracle_)
        allowance.reference = [this] { return reference_time(); };
    try {
        Bytes part = worker_.session_->next_part(allowance);
        waited_ += allowance.waited;
        worker_.all_scenes_ += allowance.waited;
        const Seconds floor =
            worker_.all_scenes_ > limits.all_scenes ? limits.scene / 10 : limits.scene;
        if (waited_ > floor && waited_ > limits.multiple * reference_time())
            throw Broken{
                WorkerFailure::timed_out,
                fmt::format("did not return: the scene takes more than {:.3g} s", waited_.count())};
        return part;
    } catch (const Broken& broken) {
        fail(broken, formula);
    }
}

SceneAnswers::Seconds SceneAnswers::reference_time()
{
    if (!reference_time_)
        reference_time_ = worker_.oracle_ ? worker_.oracle_->duration(question_) : Seconds(0);
    return *reference_time_;
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
    if (broken.cause == WorkerFailure::timed_out) ++worker_.timed_out_[formula];
    worker_.fail(broken, nullptr);
}

} // namespace rigor
