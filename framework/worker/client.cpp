// SPDX-License-Identifier: MIT
#include "worker/client.hpp"

#include "worker/finite.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t piece = std::size_t{1} << 20; // of states to advance, in one request

/// Text that a stranger wrote, fit for a terminal and for JSON: ASCII without control characters.
std::string printable(std::string text)
{
    for (char& c : text) {
        const bool plain = (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
        if (!plain) c = '?';
    }
    return text;
}

std::string text_of(const std::vector<std::byte>& bytes)
{
    return printable(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

} // namespace

std::string subject_of(FormulaIndex formula)
{
    const Formula& row = formulas[static_cast<unsigned>(formula)];
    return fmt::format("{} {}", row.tag, row.name);
}

/// How long a request may still take. The oracle is asked only once the floor is used up.
struct Worker::Allowance {
    Seconds limit;
    double multiple = 0;
    std::function<Seconds()> reference; // empty: there is none, or it has been asked
    Seconds waited{0};
    Seconds reference_took{0};

    bool used_up()
    {
        if (waited <= limit) return false;
        if (reference) {
            reference_took = std::exchange(reference, nullptr)();
            limit = std::max(limit, multiple * reference_took);
        }
        return waited > limit;
    }

    std::string verdict() const
    {
        std::string text = fmt::format("did not return within {:.3g} s", limit.count());
        if (reference_took.count() > 0)
            text += fmt::format(" (the reference took {:.2g} s)", reference_took.count());
        return text;
    }
};

Worker::Worker(std::filesystem::path executable, Limits limits, Worker* oracle)
    : executable_(std::move(executable)), limits_(limits), oracle_(oracle)
{
}

void Worker::start()
{
    if (process_) return;
    if (failed_starts_ >= 2) throw *start_failure_; // it will not start the next time either
    process_ = std::make_unique<Process>(executable_, limits_);
    sequence_ = 1;
    printed_ = 0;
    const std::string request = std::exchange(subject_, "the start of the program");
    try {
        Allowance allowance{limits_.start, 0, nullptr};
        await_reply(allowance);
        const std::uint64_t expected = contract_fingerprint();
        const Reply hello = take_reply(sizeof expected);
        if (wire::decode_all<std::uint64_t>(hello.payload) != expected)
            fail(WorkerFailure::malformed,
                 "was built from other headers than this: build it again");
    } catch (const wire::Malformed& malformed) {
        fail(WorkerFailure::malformed, fmt::format("sent no answer: {}", malformed.what()));
    } catch (const WorkerFailure& failure) {
        ++failed_starts_;
        start_failure_ = failure;
        throw;
    }
    failed_starts_ = 0;
    subject_ = request;
}

void Worker::renew()
{
    process_.reset();
}

Worker::Reply Worker::exchange(Request kind, std::uint32_t argument,
                               std::span<const std::byte> payload, std::size_t largest,
                               Allowance& allowance)
{
    if (payload.size() > Channel::capacity)
        throw std::length_error(fmt::format("{}: its arguments take {} bytes, a request holds {}",
                                            subject_, payload.size(), Channel::capacity));
    start();
    Channel& channel = process_->channel();
    if (channel.reply.load(std::memory_order_acquire) != sequence_)
        fail(WorkerFailure::malformed, "answered before it was asked");
    channel.kind = kind;
    channel.argument = argument;
    channel.request_size = payload.size();
    std::copy(payload.begin(), payload.end(), channel.payload);
    printed_ = 0;
    ++sequence_;
    post(channel.request, sequence_);
    await_reply(allowance);
    return take_reply(largest);
}

/// Waits until the reply with our sequence number is there. Looks after the process meanwhile.
void Worker::await_reply(Allowance& allowance)
{
    const std::atomic<std::uint32_t>& reply = process_->channel().reply;
    const Clock::time_point start = Clock::now();
    const Seconds before = allowance.waited;
    std::chrono::milliseconds slice(1);
    for (;;) {
        const std::uint32_t now = await_change(reply, sequence_ - 1, slice);
        allowance.waited = before + (Clock::now() - start);
        if (now == sequence_) return;
        if (now != sequence_ - 1) fail(WorkerFailure::malformed, "answered out of turn");
        collect_output();
        if (const auto ending = process_->ending()) {
            if (reply.load(std::memory_order_acquire) == sequence_) return; // it answered first
            fail(ending->cause, ending->text);
        }
        if (allowance.used_up()) fail(WorkerFailure::timed_out, allowance.verdict());
        slice = std::min(2 * slice, std::chrono::milliseconds(20));
    }
}

Worker::Reply Worker::take_reply(std::size_t largest)
{
    // Each word is read once, the payload is copied: from here on nothing can change under us.
    Channel& channel = process_->channel();
    const Status status = channel.status;
    const std::uint64_t size = channel.reply_size;
    if (status > Status::last) fail(WorkerFailure::malformed, "sent an answer of no known kind");
    const bool told = status != Status::done && status != Status::more;
    const std::size_t most = std::min(told ? Channel::longest_text : largest, Channel::capacity);
    if (size > most)
        fail(WorkerFailure::malformed,
             fmt::format("sent {} bytes where an answer has at most {}", size, most));
    return {status, Bytes(channel.payload, channel.payload + size)};
}

void Worker::collect_output()
{
    while (const std::size_t n = process_->drain(output_, limits_.output_kept)) {
        printed_ += n;
        if (printed_ > limits_.output)
            fail(WorkerFailure::flooded,
                 fmt::format("printed more than {} kB", limits_.output / 1024));
    }
}

void Worker::fail(WorkerFailure::Cause cause, const std::string& text)
{
    if (process_ && cause != WorkerFailure::flooded) {
        // The last words, but no more than a pipe holds.
        for (int i = 0; i < 16 && process_->drain(output_, limits_.output_kept) > 0; ++i) {
        }
    }
    process_.reset();
    WorkerFailure failure(cause, subject_, text);
    failure.output = printable(std::exchange(output_, {}));
    throw failure;
}

void Worker::fail_as_told(const Reply& reply)
{
    const std::string text = text_of(reply.payload);
    if (reply.status == Status::threw) fail(WorkerFailure::threw, "threw " + text);
    if (reply.status == Status::not_implemented) throw NotImplemented(text);
    if (reply.status == Status::not_finite) throw NotFinite(subject_, text);
    fail(WorkerFailure::malformed, "sent a piece of a trajectory where a result was due");
}

std::string Worker::take_output()
{
    for (int i = 0; process_ && i < 16 && process_->drain(output_, limits_.output_kept) > 0; ++i) {
    }
    return printable(std::exchange(output_, {}));
}

Bytes Worker::call(FormulaIndex formula, std::span<const std::byte> arguments, std::size_t largest)
{
    subject_ = subject_of(formula);
    const auto index = static_cast<std::uint32_t>(formula);
    Allowance allowance{limits_.call, limits_.multiple, nullptr};
    if (oracle_)
        allowance.reference = [&] { return oracle_->duration(Request::call, index, arguments); };
    Reply reply = exchange(Request::call, index, arguments, largest, allowance);
    if (reply.status != Status::done) fail_as_told(reply);
    return std::move(reply.payload);
}

void Worker::run_scene(const std::string& scene_text, const std::string& scene_name, Record record,
                       const ByteSink& sink)
{
    subject_ = "scene " + scene_name;
    Bytes request;
    wire::encode(request, scene_text);
    wire::encode(request, scene_name);
    const auto argument = static_cast<std::uint32_t>(record);
    Allowance allowance{limits_.scene, limits_.multiple, nullptr};
    if (oracle_)
        allowance.reference = [&] {
            return oracle_->duration(Request::run_scene, argument, request);
        };
    Reply reply = exchange(Request::run_scene, argument, request, Channel::capacity, allowance);
    while (reply.status == Status::more) {
        try {
            sink(reply.payload);
        } catch (...) {
            renew(); // it is in the midst of a scene that nobody will take
            throw;
        }
        reply = exchange(Request::proceed, 0, {}, Channel::capacity, allowance);
    }
    if (reply.status != Status::done) fail_as_told(reply);
    if (!reply.payload.empty()) fail(WorkerFailure::malformed, "sent more after its end");
}

std::vector<std::vector<RigidState>> Worker::advance(const std::string& scene_text,
                                                     const std::string& scene_name,
                                                     const std::vector<Start>& starts, int steps)
{
    using States = std::vector<std::vector<RigidState>>;
    subject_ = "scene " + scene_name;
    States all;
    while (all.size() < starts.size()) {
        Bytes encoded;
        std::vector<Start> some;
        std::size_t largest = sizeof(std::uint64_t);
        while (all.size() + some.size() < starts.size() && largest < piece) {
            some.push_back(starts[all.size() + some.size()]);
            largest += sizeof(std::uint64_t) +
                       some.back().second.size() * wire::encoded_size<RigidState>().most;
        }
        Bytes request;
        wire::encode(request, scene_text);
        wire::encode(request, scene_name);
        wire::encode(request, steps);
        wire::encode(request, some);

        Allowance allowance{limits_.call, limits_.multiple, nullptr};
        if (oracle_)
            allowance.reference = [&] { return oracle_->duration(Request::advance, 0, request); };
        const Reply reply = exchange(Request::advance, 0, request, largest, allowance);
        if (reply.status != Status::done) fail_as_told(reply);
        States states;
        try {
            states = wire::decode_all<States>(reply.payload);
        } catch (const wire::Malformed& malformed) {
            fail(WorkerFailure::malformed, fmt::format("sent no answer: {}", malformed.what()));
        }
        if (states.size() != some.size())
            fail(WorkerFailure::malformed, "sent states for other starts");
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (states[i].size() != some[i].second.size())
                fail(WorkerFailure::malformed, "sent states of other bodies");
            for (std::size_t body = 0; body < states[i].size(); ++body) {
                const std::string which = find_non_finite(states[i][body]);
                if (!which.empty())
                    throw NotFinite(subject_,
                                    fmt::format("t = {:.6g} s, body {}: {} after {} steps",
                                                some[i].first, body, which, steps));
            }
            all.push_back(std::move(states[i]));
        }
    }
    return all;
}

/// How long this implementation takes for a request; 0 if it fails.
Worker::Seconds Worker::duration(Request kind, std::uint32_t argument,
                                 std::span<const std::byte> payload)
{
    subject_ = "the oracle";
    Allowance allowance{limits_.oracle, 0, nullptr};
    try {
        Reply reply = exchange(kind, argument, payload, Channel::capacity, allowance);
        while (reply.status == Status::more)
            reply = exchange(Request::proceed, 0, {}, Channel::capacity, allowance);
        return reply.status == Status::done ? allowance.waited : Seconds(0);
    } catch (const WorkerFailure&) {
        return Seconds(0);
    }
}

} // namespace rigor
