// SPDX-License-Identifier: MIT
// A worker: the engine linked with one implementation of the formulas. It answers the requests of
// one client through shared memory (descriptor 3) until it is killed.
#include "formulas/not_implemented.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/parallel/keep_memory.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/trajectory.hpp"
#include "worker/channel.hpp"
#include "worker/main/dispatch.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace rigor {

namespace {

/// Ends this process when the client dies, since nobody is left to answer. This is called before
/// the initializers of the implementation, so that it also ends an endless loop in one of them.
[[gnu::constructor(101)]] void die_with_client()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

/// Makes the call stack large enough for a recursion over 100 000 stacked bodies, which is deep but
/// not wrong. The limit is set from inside, since a limit from outside is lost while
/// exec is under way.
[[gnu::constructor(102)]] void make_room_for_recursion()
{
    const rlimit stack = {rlim_t{32} << 20, rlim_t{32} << 20};
    setrlimit(RLIMIT_STACK, &stack); // if that is not allowed, the old limit stays
}

// The settings of a run. The build decides whether the formulas are the reference's, so that no
// other implementation can claim it. Other formulas may not be safe to call from several threads.
RunSettings settings([[maybe_unused]] int threads)
{
#ifdef RIGOR_REFERENCE
    return {.formulas_are_reference = true, .threads = std::clamp(threads, 1, 64)};
#else
    return {};
#endif
}

wire::Bytes advance_states(std::span<const std::byte> payload)
{
    wire::Reader reader(payload);
    std::string text, name;
    int steps = 0;
    std::vector<Moment> starts;
    wire::decode(reader, text);
    wire::decode(reader, name);
    wire::decode(reader, steps);
    wire::decode(reader, starts);
    reader.end();
    wire::Bytes states;
    wire::encode(states, advance(parse_scene(text, name), starts, steps, settings(1)));
    return states;
}

/// Answers requests, one after the other.
class Server {
public:
    explicit Server(Channel& channel) : channel_(channel) {}

    void greet()
    {
        wire::Bytes hello;
        wire::encode(hello, contract_fingerprint());
        reply(Status::done, hello);
    }

    void serve_next()
    {
        await_request();
        try {
            reply(Status::done, answer());
        } catch (const NotImplemented& stub) {
            reply_text(Status::not_implemented, stub.what());
        } catch (const NonFiniteState& state) {
            reply_text(Status::not_finite, state.what());
        } catch (const std::bad_alloc&) {
            reply_text(Status::threw, "std::bad_alloc: out of memory");
        } catch (const std::exception& exception) {
            const char* text = exception.what();
            reply_text(Status::threw,
                       text ? std::string("an exception: ") + text : "an exception without a text");
        } catch (const abi::__forced_unwind&) {
            throw; // pthread_exit: not an exception, and it must not be stopped
        } catch (...) {
            reply_text(Status::threw, "something that is no std::exception");
        }
    }

private:
    void await_request()
    {
        ++sequence_;
        std::uint32_t now = channel_.request.load(std::memory_order_acquire);
        while (now != sequence_)
            now = await_change(channel_.request, now, std::chrono::hours(1));
    }

    wire::Bytes answer()
    {
        const std::span<const std::byte> payload(channel_.payload, channel_.request_size);
        switch (channel_.kind.load()) {
        case Request::call:
            return call_formula(channel_.argument, payload);
        case Request::run_scene:
            return stream_scene(payload);
        case Request::advance:
            return advance_states(payload);
        }
        throw wire::Malformed("there is no such request");
    }

    wire::Bytes stream_scene(std::span<const std::byte> payload);
    void stream(std::span<const std::byte> bytes);

    void reply(Status status, std::span<const std::byte> payload)
    {
        if (payload.size() > Channel::capacity) throw std::length_error("an answer is too large");
        std::copy(payload.begin(), payload.end(), channel_.payload);
        channel_.status = status;
        channel_.reply_size = payload.size();
        post(channel_.reply, sequence_);
    }

    void reply_text(Status status, std::string text)
    {
        text.resize(std::min(text.size(), Channel::longest_text));
        reply(status, std::as_bytes(std::span(text)));
    }

    Channel& channel_;
    std::uint32_t streamed_ = 0;
    std::uint32_t sequence_ = 1; // the current request; request 1 is to get ready
};

wire::Bytes Server::stream_scene(std::span<const std::byte> payload)
{
    wire::Reader reader(payload);
    std::string text, name;
    wire::decode(reader, text);
    wire::decode(reader, name);
    reader.end();
    const std::uint32_t argument = channel_.argument.load();
    const Record record{static_cast<int>(argument & 1)};
    const int threads = static_cast<int>(argument >> 1);
    streamed_ = 0;
    run_scene(
        parse_scene(text, name), record,
        [this](std::span<const std::byte> bytes) { stream(bytes); }, settings(threads));
    return {};
}

/// Writes bytes to the ring. Waits only while the ring is full, so the scene goes on while the
/// client reads.
void Server::stream(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const std::uint32_t taken = channel_.taken.load(std::memory_order_acquire);
        const std::uint32_t room = Channel::ring - (streamed_ - taken);
        if (room == 0) {
            await_change(channel_.taken, taken, std::chrono::hours(1));
            continue;
        }
        const std::uint32_t at = streamed_ % Channel::ring;
        const std::size_t n = std::min<std::size_t>({bytes.size(), room, Channel::ring - at});
        std::copy_n(bytes.begin(), n, channel_.stream + at);
        bytes = bytes.subspan(n);
        streamed_ += static_cast<std::uint32_t>(n);
        channel_.streamed.store(streamed_, std::memory_order_release);
    }
    wake(channel_.reply);
}

[[noreturn]] void run(const char* client)
{
    if (std::to_string(getppid()) != client) _exit(0); // the client is dead already
    void* memory = mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) _exit(1);
    close(3);
    // A process that an implementation forks must not take part in the conversation.
    madvise(memory, sizeof(Channel), MADV_DONTFORK);
    // Output is flushed after each line, so that it is seen even if the next line crashes.
    std::setvbuf(stdout, nullptr, _IOLBF, 0);

    Server server(*static_cast<Channel*>(memory));
    server.greet();
    for (;;)
        server.serve_next();
}

} // namespace

} // namespace rigor

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("a worker is started by its client: use ./rigor\n", stderr);
        return 2;
    }
    rigor::keep_freed_memory();
    rigor::run(argv[1]);
}
