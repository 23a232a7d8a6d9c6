// SPDX-License-Identifier: MIT
// The memory that a worker shares with its client, and how each waits for the other.
//
// The client writes a request and raises `request` to the next sequence number; the worker writes
// the reply over it and raises `reply` to the same number. The client reads what it wrote itself
// from its own variables, and copies a reply before it looks at it: the worker may write here at
// any time. A trajectory goes through a ring beside it, so that all of it is there even if the
// worker dies in the next instruction.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace rigor {

/// What a client asks.
enum class Request : std::uint32_t {
    call, // formula `argument` on the encoded arguments in the payload
    // text and name in the payload, `argument` is the Record + 2 threads: the stream, then done
    run_scene,
    advance, // text, name, steps, starts: states
};

/// What a worker answers.
enum class Status : std::uint32_t {
    done,            // the payload is the result
    not_implemented, // the payload is the text of NotImplemented
    not_finite,      // the payload says which quantity of the scene's is not
    threw,           // the payload says what was thrown
    last = threw,
};

struct Channel {
    static constexpr std::size_t capacity = std::size_t{64} << 20; // touched pages only take memory
    static constexpr std::size_t longest_text = 4096;              // in a failure [bytes]
    static constexpr std::uint32_t ring = std::uint32_t{4} << 20;  // a power of two

    alignas(64) std::atomic<std::uint32_t> request;
    std::atomic<Request> kind;
    std::atomic<std::uint32_t> argument;
    std::atomic<std::uint64_t> request_size;
    alignas(64) std::atomic<std::uint32_t> reply;
    std::atomic<Status> status;
    std::atomic<std::uint64_t> reply_size;
    // Bytes of the trajectory written and read since its start, modulo 2^32: byte n is stream[n %
    // ring].
    alignas(64) std::atomic<std::uint32_t> streamed;
    alignas(64) std::atomic<std::uint32_t> taken;
    alignas(64) std::byte stream[ring];
    std::byte payload[capacity];
};

/// Differs if the contract or this protocol does: a worker built from another one is refused.
std::uint64_t contract_fingerprint();

/// Wakes who waits for the word to change.
void wake(std::atomic<std::uint32_t>& word);

/// Sets the word and wakes who waits for it to change.
void post(std::atomic<std::uint32_t>& word, std::uint32_t value);

/// Spins for a moment, then sleeps until the word is no longer `old`, or a wake, or the time is
/// over.
/// @return the word
std::uint32_t await_change(const std::atomic<std::uint32_t>& word, std::uint32_t old,
                           std::chrono::nanoseconds longest);

} // namespace rigor
