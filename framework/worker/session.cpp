// SPDX-License-Identifier: MIT
// Asks a worker process a question and waits for its reply. While the session waits, it passes on
// the parts of the stream, collects what the process prints, and checks that the process lives and
// keeps its time limit. The function `counted` says which time counts for this limit. A reply is
// copied, so that the worker cannot change it after the checks.
#include "worker/session.hpp"

#include "worker/protocol/streamed_answer.hpp"
#include "worker/protocol/wire.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t pipe_size = 65536; // the default capacity of a pipe in Linux [bytes]
constexpr const char* out_of_turn = "answered out of turn";

} // namespace

bool Allowance::used_up()
{
    if (waited <= limit) return false;
    if (reference) {
        reference_took = std::exchange(reference, nullptr)();
        limit = std::max(limit, multiple * reference_took);
    }
    return waited > limit;
}

std::string Allowance::verdict() const
{
    const char* words = by_silence ? "sent nothing for" : "did not return within";
    std::string text = fmt::format("{} {:.3g} s", words, limit.count());
    if (reference_took.count() > 0)
        text += fmt::format(" (the reference took {:.2g} s)", reference_took.count());
    return text;
}

Session::Session(const std::filesystem::path& executable, const Limits& limits)
    : limits_(limits), process_(executable, limits)
{
    allow_moves();
}

void Session::await_greeting(Allowance& allowance)
{
    process_.await_start();
    Bytes expected;
    wire::encode(expected, contract_fingerprint());
    largest_ = expected.size();
    while (!next_part(allowance).empty()) {
    }
    if (take_reply().payload != expected)
        throw Broken{WorkerFailure::malformed,
                     "was built from other headers than this: build it again"};
}

void Session::begin(const Question& question)
{
    Channel& channel = process_.channel();
    if (channel.reply.load(std::memory_order_acquire) != sequence_)
        throw Broken{WorkerFailure::malformed, "answered before it was asked"};
    channel.kind = question.kind;
    channel.argument = question.argument;
    channel.request_size = question.payload.size();
    channel.stream.written = channel.stream.read = taken_ = 0;
    channel.answers.written = channel.answers.read = given_ = 0;
    gives_ = question.given.any();
    for (std::size_t i = 0; i < channel.given_formulas.size(); ++i)
        channel.given_formulas[i] =
            (question.given >> (64 * i) & FormulaSet(~std::uint64_t{0})).to_ullong();
    std::copy(question.payload.begin(), question.payload.end(), channel.payload);
    largest_ = question.largest;
    longest_stream_ = question.longest_stream;
    streamed_ = printed_ = 0;
    ++sequence_;
    post(channel.request, channel.request_awaited, sequence_);
}

const Reply& Session::ask(const Question& question, Allowance& allowance)
{
    begin(question);
    for (Bytes part = next_part(allowance); !part.empty(); part = next_part(allowance)) {
        if (question.sink) (*question.sink)(part);
        if (allowance.by_silence) allowance.waited = {};
    }
    return take_reply();
}

/// The part of `passed` that counts for the time limit: all of it if the worker sleeps or if /proc
/// does not tell, otherwise the time that the worker was on a processor since the last look. The
/// time in which it waits for a processor does not count, because this may take seconds on a busy
/// machine. But at least a tenth of `passed` counts, since a worker could keep the machine busy
/// itself to gain time.
/// @param is_done  whether the worker has replied or waits for an answer of the client; if it
///                 sleeps then, its sleep does not count in full
Allowance::Seconds Session::counted(Allowance::Seconds passed, bool is_done)
{
    const std::optional<Process::Progress> now = process_.progress();
    if (!now) return passed;
    const Allowance::Seconds ran = now->on_processor - seen_.on_processor;
    seen_ = *now;
    return now->sleeps && !is_done ? passed : std::clamp(ran, passed / 10, passed);
}

/// What counts of a first wait, which is one slice long at most. To look at the progress of the
/// worker takes longer than most answers, so such waits are added up until they are worth a look.
/// They count in full, sleep too, but for the time in which the worker or this process waited for a
/// processor.
/// @param has_come  whether the worker has sent something
Allowance::Seconds Session::counted_first(Allowance::Seconds passed, bool has_come)
{
    constexpr std::chrono::milliseconds worth_a_look(20);
    first_waits_ += passed;
    if (has_come && first_waits_ < worth_a_look) return {};
    const Allowance::Seconds waits = std::exchange(first_waits_, {});
    const std::optional<Process::Progress> now = process_.progress();
    if (!now) return waits;
    const Allowance::Seconds ran = now->on_processor - seen_.on_processor,
                             in_vain = now->waited_to_run - seen_.waited_to_run;
    seen_ = *now;
    return std::clamp(std::max(ran, waits - in_vain), waits / 10, waits);
}

/// Waits for a part of the stream, or until the reply with the current sequence number is there,
/// and watches the process meanwhile.
Bytes Session::next_part(Allowance& allowance)
{
    std::atomic<std::uint32_t>& reply = process_.channel().reply;
    std::atomic<std::uint32_t>& awaited = process_.channel().reply_awaited;
    std::chrono::milliseconds slice(1);
    for (bool is_first = true;; is_first = false) {
        if (Bytes part = take_stream(); !part.empty()) return part;
        const Clock::time_point start = Clock::now();
        // If the client gives answers, anything new in the stream ends the wait too: a worker that
        // waits for such an answer may have streamed only a few bytes before.
        const Until streamed{process_.channel().stream.written, taken_};
        const std::uint32_t now =
            await_change(reply, awaited, sequence_ - 1, slice, gives_ ? &streamed : nullptr);
        const Allowance::Seconds passed = Clock::now() - start;
        // If this process itself had to wait for a processor, it sees too late that the worker was
        // done. So the last wait counts as at most one slice, the longest time of a single wait.
        const bool has_replied = now == sequence_, has_streamed = streamed.word.load() != taken_;
        const bool is_done = has_replied || (gives_ && has_streamed);
        const Allowance::Seconds at_most = std::min<Allowance::Seconds>(passed, slice);
        allowance.waited += is_first ? counted_first(at_most, has_replied || has_streamed)
                                     : counted(is_done ? at_most : passed, is_done);
        if (has_replied) return take_stream();
        if (now != sequence_ - 1) throw Broken{WorkerFailure::malformed, out_of_turn};
        if (Bytes part = is_done ? take_stream() : Bytes(); !part.empty()) return part;
        collect_output();
        if (const auto ending = process_.ending()) {
            // If there is a reply, it came before the process ended, so it counts.
            if (reply.load(std::memory_order_acquire) == sequence_) continue;
            if (Bytes part = take_stream(); !part.empty()) return part;
            throw *ending;
        }
        if (allowance.used_up()) throw Broken{WorkerFailure::timed_out, allowance.verdict()};
        // If the client gives answers, the slice stays short, because a wake-up for streamed bytes
        // may be missed.
        if (!gives_) slice = std::min(2 * slice, std::chrono::milliseconds(20));
    }
}

const Reply& Session::take_reply()
{
    // Each word is read once and the payload is copied, so that the worker cannot change them
    // later.
    Channel& channel = process_.channel();
    const ReplyStatus status = channel.status;
    const std::uint64_t size = channel.reply_size;
    if (status > ReplyStatus::last)
        throw Broken{WorkerFailure::malformed, "sent an answer of no known kind"};
    const std::size_t most =
        std::min(status == ReplyStatus::done ? largest_ : Channel::longest_text, Channel::capacity);
    if (size > most)
        throw Broken{WorkerFailure::malformed,
                     fmt::format("sent {} bytes where an answer has at most {}", size, most)};
    reply_.status = status;
    reply_.payload.assign(channel.payload, channel.payload + size);
    return reply_;
}

void Session::give(FormulaIndex formula, std::span<const std::byte> answer, Allowance& allowance)
{
    const StreamedAnswer header{static_cast<std::uint32_t>(formula),
                                static_cast<std::uint32_t>(answer.size())};
    give_bytes(std::as_bytes(std::span(&header, 1)), allowance);
    give_bytes(answer, allowance);
}

void Session::give_bytes(std::span<const std::byte> bytes, Allowance& allowance)
{
    Ring& answers = process_.channel().answers;
    while (!bytes.empty()) {
        const std::uint32_t used = answers.read.load(std::memory_order_acquire);
        const std::uint32_t unread = given_ - used;
        if (unread > Ring::size) throw Broken{WorkerFailure::malformed, out_of_turn};
        if (unread == Ring::size) {
            await_room(used, allowance);
            continue;
        }
        const std::size_t n = std::min<std::size_t>(bytes.size(), Ring::size - unread);
        answers.copy_in(bytes.first(n), given_);
        bytes = bytes.subspan(n);
        given_ += static_cast<std::uint32_t>(n);
        post(answers.written, answers.written_awaited, given_);
    }
}

/// Waits for at most 20 ms until the worker has read some of the answers that were given to it. No
/// deadlock is possible: this process has read all that was streamed before this answer, so the
/// worker cannot be waiting for room in its own stream at the same time.
void Session::await_room(std::uint32_t used, Allowance& allowance)
{
    Ring& answers = process_.channel().answers;
    const Clock::time_point start = Clock::now();
    await_change(answers.read, answers.read_awaited, used, std::chrono::milliseconds(20));
    allowance.waited += counted(Clock::now() - start, false);
    if (const auto ending = process_.ending()) throw *ending;
    if (allowance.used_up()) throw Broken{WorkerFailure::timed_out, allowance.verdict()};
}

Bytes Session::rest_of_stream()
{
    const std::uint32_t n =
        process_.channel().stream.written.load(std::memory_order_acquire) - taken_;
    if (n > Ring::size || streamed_ + n > longest_stream_) return {};
    return read_stream(n);
}

/// Takes the next n bytes out of the stream, which makes room in the ring. The caller has checked
/// that they are there.
Bytes Session::read_stream(std::uint32_t n)
{
    Ring& stream = process_.channel().stream;
    Bytes bytes(n);
    stream.copy_out(taken_, bytes);
    taken_ += n;
    streamed_ += n;
    stream.read.store(taken_); // must come before `wake` reads `read_awaited`, see `post`
    // A worker waits only if it found the ring full. The client reads a full ring in at most two
    // parts. One of these is at least half of the ring, and only such a part wakes the worker.
    if (n >= Ring::size / 2) wake(stream.read, stream.read_awaited);
    return bytes;
}

Bytes Session::take_stream()
{
    const std::uint32_t n =
        process_.channel().stream.written.load(std::memory_order_acquire) - taken_;
    if (n == 0) return {};
    // A worker may overwrite any word of the channel, so `n` may be too large. The message is the
    // same as for a wrong sequence number.
    if (n > Ring::size) throw Broken{WorkerFailure::malformed, out_of_turn};
    if (streamed_ + n > longest_stream_)
        throw Broken{WorkerFailure::flooded,
                     longest_stream_ == 0
                         ? "streamed, although no scene was asked for"
                         : fmt::format("streamed more than {} MB", longest_stream_ >> 20)};
    return read_stream(n);
}

void Session::collect_output()
{
    while (const std::size_t n = process_.drain(output_, limits_.output_kept)) {
        printed_ += n;
        if (printed_ > limits_.output)
            throw Broken{WorkerFailure::flooded,
                         fmt::format("printed more than {} kB", limits_.output / 1024)};
    }
}

std::string Session::take_output()
{
    // Stops after about as many bytes as a pipe holds, since a process that prints without end
    // would keep this loop running forever.
    for (std::size_t n = 0; n <= pipe_size;) {
        const std::size_t more = process_.drain(output_, limits_.output_kept);
        if (more == 0) break;
        n += more;
    }
    return std::exchange(output_, {});
}

} // namespace rigor
