// SPDX-License-Identifier: MIT
// Serves one client through the shared memory in descriptor 3. A request is awaited, answered by
// a formula or by the engine, and replied to; what a formula throws becomes a reply too.
#include "worker/main/server.hpp"

#include "formulas/not_implemented.hpp"
#include "worker/main/dispatch.hpp"
#include "worker/protocol/streamed_answer.hpp"

#include <algorithm>
#include <cstdio>
#include <cxxabi.h>
#include <new>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace rigor {

void Server::greet()
{
    wire::Bytes hello;
    wire::encode(hello, contract_fingerprint());
    reply(ReplyStatus::done, hello);
}

void Server::serve_next()
{
    await_request();
    try {
        answer();
        reply(ReplyStatus::done, answer_);
    } catch (const NotImplemented& stub) {
        reply_text(ReplyStatus::not_implemented, stub.what());
    } catch (const MissingFormula& missing) {
        wire::Bytes index;
        wire::encode(index, missing.index);
        reply(ReplyStatus::missing, index);
    } catch (const NonFiniteAnswer& state) {
        reply_text(ReplyStatus::not_finite, state.text);
    } catch (const std::bad_alloc&) {
        reply_text(ReplyStatus::threw, "std::bad_alloc: out of memory");
    } catch (const std::exception& exception) {
        const char* text = exception.what();
        reply_text(ReplyStatus::threw,
                   text ? std::string("an exception: ") + text : "an exception without a text");
    } catch (const abi::__forced_unwind&) {
        throw; // pthread_exit: if this were not thrown again, the C library would abort
    } catch (...) {
        reply_text(ReplyStatus::threw, "something that is no std::exception");
    }
}

void Server::await_request()
{
    ++sequence_;
    std::uint32_t now = channel_.request.load(std::memory_order_acquire);
    while (now != sequence_)
        now = await_change(channel_.request, channel_.request_awaited, now, std::chrono::hours(1));
}

void Server::answer()
{
    const std::span<const std::byte> payload(channel_.payload, channel_.request_size);
    switch (const Request kind = channel_.kind; kind) {
    case Request::call:
        return call_formula(channel_.argument, payload, answer_);
    case Request::run_scene:
    case Request::advance:
        return run_scenes(kind, payload);
    }
    throw wire::Malformed("there is no such request");
}

void Server::run_scenes(Request kind, std::span<const std::byte> payload)
{
    streamed_ = announced_ = used_ = 0;
    answer_.clear();
    rigor_run_scenes(
        {kind, SceneOptions::unpacked(channel_.argument), payload, is_reference_, given_formulas(),
         [this](FormulaIndex formula, wire::Bytes& answer) { take_answer(formula, answer); }},
        [this](std::span<const std::byte> bytes) { stream(bytes); }, answer_);
}

void Server::reply(ReplyStatus status, std::span<const std::byte> payload)
{
    if (payload.size() > Channel::capacity) throw std::length_error("an answer is too large");
    std::copy(payload.begin(), payload.end(), channel_.payload);
    channel_.status = status;
    channel_.reply_size = payload.size();
    post(channel_.reply, channel_.reply_awaited, sequence_);
}

void Server::reply_text(ReplyStatus status, std::string text)
{
    text.resize(std::min(text.size(), Channel::longest_text));
    reply(status, std::as_bytes(std::span(text)));
}

// Writes to the ring, which the client reads while the scene goes on. Waking the client takes
// longer than most writes, so the client is woken rarely. Without being woken, the client looks at
// the ring by itself after at most 20 ms.
void Server::stream(std::span<const std::byte> bytes)
{
    // The client is woken only for this many new bytes, because each wake-up costs a system call.
    constexpr std::uint32_t worth_waking = std::uint32_t{1} << 16; // [bytes]
    Ring& ring = channel_.stream;
    while (!bytes.empty()) {
        const std::uint32_t taken = ring.read.load(std::memory_order_acquire);
        const std::uint32_t room = Ring::size - (streamed_ - taken);
        if (room == 0) { // the scene waits only while the ring is full
            wake(channel_.reply, channel_.reply_awaited);
            await_change(ring.read, ring.read_awaited, taken, std::chrono::hours(1));
            continue;
        }
        const std::size_t n = std::min<std::size_t>(bytes.size(), room);
        ring.copy_in(bytes.first(n), streamed_);
        bytes = bytes.subspan(n);
        streamed_ += static_cast<std::uint32_t>(n);
        ring.written.store(streamed_, std::memory_order_release);
    }
    if (streamed_ - announced_ < worth_waking) return;
    announced_ = streamed_;
    wake(channel_.reply, channel_.reply_awaited);
}

FormulaSet Server::given_formulas() const
{
    FormulaSet set;
    for (std::size_t i = 0; i < channel_.given_formulas.size(); ++i)
        set |= FormulaSet(channel_.given_formulas[i].load()) << (64 * i);
    return set;
}

// The client's engine makes the same calls in the same order, so the next answer in the ring is
// that of this formula.
void Server::take_answer(FormulaIndex formula, wire::Bytes& answer)
{
    StreamedAnswer header{};
    take_bytes(std::as_writable_bytes(std::span(&header, 1)));
    if (header.formula != static_cast<std::uint32_t>(formula) || header.size > Channel::capacity)
        throw wire::Malformed("the answer that was given is that of another formula");
    answer.resize(header.size);
    take_bytes(answer);
}

void Server::take_bytes(std::span<std::byte> bytes)
{
    Ring& ring = channel_.answers;
    while (!bytes.empty()) {
        const std::uint32_t given = ring.written.load(std::memory_order_acquire);
        if (given == used_) {
            // The client gives an answer only after it has read all that was streamed before the
            // call. So it is woken, even for fewer bytes than `worth_waking`.
            wake(channel_.reply, channel_.reply_awaited);
            await_change(ring.written, ring.written_awaited, given, std::chrono::hours(1));
            continue;
        }
        const std::size_t n = std::min<std::size_t>(bytes.size(), given - used_);
        ring.copy_out(used_, bytes.first(n));
        bytes = bytes.subspan(n);
        used_ += static_cast<std::uint32_t>(n);
        post(ring.read, ring.read_awaited, used_);
    }
}

int run_worker(bool is_reference)
{
    void* memory = mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) {
        std::fputs("a worker is started by its client: use ./rigor\n", stderr);
        return 2;
    }
    close(3);
    // A process that an implementation forks does not get this memory, so it cannot send answers.
    madvise(memory, sizeof(Channel), MADV_DONTFORK);
    // Output is flushed after each line, so that it is seen even if the next line crashes.
    std::setvbuf(stdout, nullptr, _IOLBF, 0);

    Server server(*static_cast<Channel*>(memory), is_reference);
    server.greet();
    for (;;)
        server.serve_next();
}

} // namespace rigor
