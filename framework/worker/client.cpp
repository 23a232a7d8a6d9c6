// SPDX-License-Identifier: MIT
// Sends requests to a worker process and checks the replies. The process is started when the first
// request needs it. After a failure it is ended, the failure is thrown with the output of the
// implementation, and the next request starts a fresh process.
#include "worker/client.hpp"

#include "errors/printable.hpp"
#include "worker/protocol/finite.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

/// `advance` divides its start states among several requests. A request is full when its states
/// reach this size [bytes].
constexpr std::size_t piece = std::size_t{1} << 18;

std::string text_of(const Bytes& bytes)
{
    return printable(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

/// Tag and name of the formula whose index a worker sent.
std::string missing_in(const Bytes& reply)
{
    try {
        const auto index = wire::decode_all<unsigned>(reply);
        if (index < formula_count) return subject_of(FormulaIndex{index});
    } catch (const wire::Malformed&) {
    }
    return "a formula";
}

/// The size of the encoded states of all bodies [bytes].
std::size_t encoded_size(const Moment& moment)
{
    static const std::size_t state = wire::encoded_size<RigidState>().most;
    return sizeof(std::uint64_t) + moment.second.size() * state;
}

} // namespace

const std::string& subject_of(FormulaIndex formula)
{
    static const std::vector<std::string> subjects = [] {
        std::vector<std::string> all;
        for (const Formula& row : formulas)
            all.push_back(fmt::format("{} {}", row.tag, row.name));
        return all;
    }();
    return subjects[static_cast<unsigned>(formula)];
}

Worker::Worker(std::filesystem::path executable, Limits limits, Worker* oracle)
    : executable_(std::move(executable)), limits_(limits), oracle_(oracle),
      budget_(limits, oracle != nullptr)
{
}

void Worker::start()
{
    if (session_) return;
    if (failed_starts_ >= 2) throw *start_failure_; // the program would fail to start again
    session_ = spare_ ? std::move(spare_) : std::make_unique<Session>(executable_, limits_);
    Allowance allowance{budget_.limit_of_start()};
    try {
        session_->await_greeting(allowance);
        budget_.started(allowance.waited);
        failed_starts_ = 0;
        if (ending_) spare_ = std::make_unique<Session>(executable_, limits_);
    } catch (const std::system_error&) {
        session_.reset();
        throw;
    } catch (const Broken& broken) {
        budget_.started(allowance.waited);
        fail_to_start(broken, allowance.limit);
    }
}

void Worker::fail_to_start(Broken broken, Seconds limit)
{
    subject_ = "the start of the program";
    if (broken.cause == WorkerFailure::timed_out) broken.text = budget_.why_start_ended(limit);
    try {
        fail(broken, nullptr);
    } catch (const WorkerFailure& failure) {
        ++failed_starts_;
        start_failure_ = failure;
        throw;
    }
}

void Worker::renew()
{
    if (!session_) return;
    output_ += session_->take_output();
    ended_ran_ += session_->on_processor();
    session_->begin_end();
    ending_ = std::move(session_);
}

void Worker::begin_budget_again(Seconds budget)
{
    budget_.begin_again(budget);
    ended_ran_ = session_ ? -session_->on_processor() : Seconds(0);
}

std::string Worker::take_output()
{
    if (session_) output_ += session_->take_output();
    std::string text = std::exchange(output_, {});
    text.resize(std::min(text.size(), limits_.output_kept));
    return printable(text);
}

void Worker::fail(const Broken& broken, const ByteSink* sink)
{
    const Bytes rest = sink ? session_->rest_of_stream() : Bytes();
    renew();
    try {
        if (!rest.empty()) (*sink)(rest);
    } catch (const std::exception&) {
        // If `sink` refuses the last bytes, its exception is ignored, because the failure in
        // `broken` is reported anyway.
    }
    WorkerFailure failure(broken.cause, subject_, broken.text);
    failure.output = take_output();
    throw failure;
}

const Reply& Worker::exchange(const Question& question, Allowance& allowance)
{
    if (question.payload.size() > Channel::capacity)
        throw std::length_error(fmt::format("{}: {} bytes to send, and a request holds {}",
                                            subject_, question.payload.size(), Channel::capacity));
    start();
    try {
        return session_->ask(question, allowance);
    } catch (const Broken& broken) {
        fail(broken, question.sink);
    } catch (...) {
        renew(); // the sink threw, so the rest of the scene cannot be passed on
        throw;
    }
}

const Bytes& Worker::ask(const Question& question, Allowance& allowance)
{
    allowance.multiple = limits_.multiple;
    allowance.by_silence = question.sink && limits_.scene_by_silence;
    if (oracle_) allowance.reference = [&] { return oracle_->duration(question); };
    const Reply& reply = exchange(question, allowance);
    if (reply.status != ReplyStatus::done) refuse(reply);
    return reply.payload;
}

/// Throws the error that a reply without a result reports.
void Worker::refuse(const Reply& reply)
{
    switch (reply.status) {
    case ReplyStatus::not_implemented:
        throw NotImplemented(text_of(reply.payload));
    case ReplyStatus::not_finite:
        throw NotFinite(subject_, text_of(reply.payload));
    case ReplyStatus::missing:
        throw FormulaMissing(subject_, missing_in(reply.payload));
    case ReplyStatus::done:
    case ReplyStatus::threw:
        break;
    }
    fail({WorkerFailure::threw, "threw " + text_of(reply.payload)}, nullptr);
}

/// As long as this object lives, the time that this worker computes does not count as time of its
/// own calls. The worker is then asked as the oracle, to tell how long another worker may take.
class Worker::Uncounted {
public:
    explicit Uncounted(Worker& worker) : worker_(worker), before_(worker.ran()) {}
    ~Uncounted() { worker_.ended_ran_ -= worker_.ran() - before_; }
    Uncounted(const Uncounted&) = delete;
    Uncounted& operator=(const Uncounted&) = delete;

private:
    Worker& worker_;
    Seconds before_;
};

Worker::Seconds Worker::ran() const
{
    return ended_ran_ + (session_ ? session_->on_processor() : Seconds(0));
}

Worker::Seconds Worker::duration(Question question)
{
    static const ByteSink nobody = [](std::span<const std::byte>) {};
    if (question.sink) question.sink = &nobody;
    subject_ = "the oracle";
    Allowance allowance{limits_.oracle};
    const Uncounted measurement(*this);
    try {
        const Reply& reply = exchange(question, allowance);
        return reply.status == ReplyStatus::done ? allowance.waited : Seconds(0);
    } catch (const WorkerFailure&) {
        return Seconds(0); // then the time limit stays at its floor
    }
}

/// How fast this worker streams the answers of a scene; all values are 0 if the scene fails.
Pace Worker::pace(const Question& question)
{
    subject_ = "the oracle";
    Pace pace;
    const Uncounted measurement(*this);
    try {
        start();
        session_->begin(question);
        for (Allowance allowance{limits_.oracle};;) {
            const Seconds before = allowance.waited;
            const Bytes part = session_->next_part(allowance);
            pace.longest_wait = std::max(pace.longest_wait, allowance.waited - before);
            pace.whole = allowance.waited;
            pace.size += part.size();
            if (part.empty()) break;
        }
        return session_->take_reply().status == ReplyStatus::done ? pace : Pace();
    } catch (const Broken&) {
        renew();
    } catch (const WorkerFailure&) {
    }
    return {}; // then the time limits stay at their floors
}

const Bytes& Worker::call(FormulaIndex formula, std::span<const std::byte> arguments,
                          std::size_t largest)
{
    subject_ = subject_of(formula);
    if (budget_.is_given_up(formula))
        throw WorkerFailure(WorkerFailure::timed_out, subject_, budget_.why_given_up(formula));
    const Question question{Request::call, static_cast<std::uint32_t>(formula), arguments, largest};
    Allowance allowance{budget_.floor_of_call()};
    start(); // a failure of the start is not one of the formula
    try {
        const Bytes& result = ask(question, allowance);
        budget_.returned(formula, allowance.waited);
        if (budget_.is_compared(formula)) {
            budget_.compare(formula, allowance.waited,
                            oracle_ ? oracle_->duration(question) : Seconds(0));
            budget_.ran(ran());
        }
        return result;
    } catch (const WorkerFailure& failure) {
        budget_.failed(formula, allowance.waited, failure.cause == WorkerFailure::timed_out);
        throw;
    }
}

void Worker::run_scene(const std::string& scene_text, const std::string& scene_name, Record record,
                       const ByteSink& sink, int threads)
{
    subject_ = "scene " + scene_name;
    Bytes request;
    wire::encode(request, scene_text);
    wire::encode(request, scene_name);
    SceneOptions options;
    options.every_step = record == Record::every_step;
    options.threads = threads;
    Allowance allowance{limits_.scene};
    ask({Request::run_scene, options.packed(), request, 0, limits_.trajectory, &sink}, allowance);
}

Worker::States Worker::advance(const std::string& scene_text, const std::string& scene_name,
                               const std::vector<Start>& starts, int steps)
{
    subject_ = "scene " + scene_name;
    States states;
    for (std::size_t first = 0, last = 0; first < starts.size(); first = last) {
        std::size_t size = 0;
        while (last < starts.size() && size < piece)
            size += encoded_size(starts[last++]);
        const auto some = std::span(starts).subspan(first, last - first);
        for (std::vector<RigidState>& state : advance_some(scene_text, scene_name, some, steps))
            states.push_back(std::move(state));
    }
    return states;
}

Worker::States Worker::advance_some(const std::string& scene_text, const std::string& scene_name,
                                    std::span<const Start> starts, int steps)
{
    Bytes request;
    wire::encode(request, scene_text);
    wire::encode(request, scene_name);
    wire::encode(request, steps);
    wire::encode(request, std::vector<Start>(starts.begin(), starts.end()));
    std::size_t largest = sizeof(std::uint64_t);
    for (const Start& start : starts)
        largest += encoded_size(start);
    Allowance allowance{limits_.call};
    const Bytes& reply = ask({Request::advance, 0, request, largest}, allowance);
    States states;
    try {
        states = wire::decode_all<States>(reply);
    } catch (const wire::Malformed& malformed) {
        fail({WorkerFailure::malformed, fmt::format("sent no answer: {}", malformed.what())},
             nullptr);
    }
    const auto same_bodies = [](const std::vector<RigidState>& state, const Start& start) {
        return state.size() == start.second.size();
    };
    if (!std::equal(states.begin(), states.end(), starts.begin(), starts.end(), same_bodies))
        fail({WorkerFailure::malformed, "sent states of other bodies"}, nullptr);
    for (std::size_t i = 0; i < states.size(); ++i)
        for (std::size_t body = 0; body < states[i].size(); ++body)
            if (const std::string which = find_non_finite(states[i][body]); !which.empty())
                throw NotFinite(subject_, fmt::format("{} of body {}, {} steps after t = {:.6g} s",
                                                      which, body, steps, starts[i].first));
    return states;
}

} // namespace rigor
