// SPDX-License-Identifier: MIT
// A worker: the engine linked with one implementation of the formulas. It answers the requests of
// one client through shared memory (descriptor 3) until it is killed.
#include "formulas/not_implemented.hpp"
#include "rigid/non_finite.hpp"
#include "scene/trajectory.hpp"
#include "worker/channel.hpp"
#include "worker/main/dispatch.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace rigor {

namespace {

/// Nobody is left to answer once the client is dead, not even from an endless loop in an initializer
/// of the implementation: so this comes before those.
[[gnu::constructor(101)]] void die_with_client()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
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
    wire::encode(states, advance(parse_scene(text, name), starts, steps));
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
            reply_text(Status::threw, std::string("an exception: ") + exception.what());
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
        case Request::proceed:
            break;
        }
        throw wire::Malformed("there is nothing to proceed with");
    }

    wire::Bytes stream_scene(std::span<const std::byte> payload);
    void hand_over(std::span<const std::byte> record);
    void hand_over_rest();

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
    wire::Bytes pending_;        // of a trajectory, not handed over yet
    bool handed_over_ = false;   // a piece, which the client may still be reading
    std::uint32_t sequence_ = 1; // of the request being answered; the first is to get ready
};

wire::Bytes Server::stream_scene(std::span<const std::byte> payload)
{
    wire::Reader reader(payload);
    std::string text, name;
    wire::decode(reader, text);
    wire::decode(reader, name);
    reader.end();
    const Record record{static_cast<int>(channel_.argument.load())};
    try {
        run_scene(parse_scene(text, name), record,
                  [this](std::span<const std::byte> bytes) { hand_over(bytes); });
    } catch (...) {
        hand_over_rest(); // what there is up to the failure
        throw;
    }
    hand_over_rest();
    return {};
}

/// The scene goes on while the client reads a piece: a new one is handed over as soon as the last
/// was taken. Only when much has piled up does the scene wait.
void Server::hand_over(std::span<const std::byte> record)
{
    constexpr std::size_t much = std::size_t{1} << 20;
    pending_.insert(pending_.end(), record.begin(), record.end());
    const bool taken = channel_.request.load(std::memory_order_acquire) == sequence_ + 1;
    if (!handed_over_ || taken || pending_.size() >= much) {
        if (handed_over_) await_request();
        reply(Status::more, pending_);
        handed_over_ = true;
        pending_.clear();
    }
}

void Server::hand_over_rest()
{
    if (handed_over_) await_request();
    handed_over_ = false;
    if (!pending_.empty()) {
        reply(Status::more, pending_);
        pending_.clear();
        await_request();
    }
}

[[noreturn]] void run(const char* client)
{
    if (std::to_string(getppid()) != client) _exit(0); // it died before it could be noticed
    void* memory = mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) _exit(1);
    close(3);
    // A process that an implementation forks has no part in the conversation.
    madvise(memory, sizeof(Channel), MADV_DONTFORK);
    // What it prints is seen even if it crashes in the next line.
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
    rigor::run(argv[1]);
}
