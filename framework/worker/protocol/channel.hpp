// SPDX-License-Identifier: MIT
// The memory that a worker shares with its client, and how each waits for the other.
//
// The client writes a request and sets `request` to the next sequence number; the worker writes the
// reply over the request and sets `reply` to the same number. The worker may write to this memory
// at any time. So the client keeps its numbers in variables outside this memory, and copies a reply
// before it looks at it. What a scene streams goes through a separate ring buffer, so that all of
// it can be read even if the worker dies in the next instruction. A second ring buffer has the
// answers that the client gives to a scene in place of the worker's own formulas.
//
// Before a process sleeps until a word changes, it says so in a second word beside the first. The
// other process wakes it only if this second word is set, since waking is a system call and takes
// as long as the rest of a request. A worker that does not set the second word is not woken, and
// exceeds its time limit.
#pragma once

#include "formulas/table.hpp"
#include "worker/protocol/ring.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace rigor {

/// The kinds of requests.
enum class Request : std::uint32_t {
    call,      // calls the formula with index `argument`; the payload has the encoded arguments
    run_scene, // runs a scene: the payload has its text and name, `argument` the SceneOptions
    // Does time steps of a scene from given states. The payload has the scene's text and name, the
    // number of steps, and a list of start states with their times; the reply has, for each of
    // them, the states after these steps.
    advance,
};

/// How a scene is run, and what the worker streams to the client.
struct SceneOptions {
    /// Whether the answers of the formulas are streamed, one after the other, instead of the
    /// trajectory.
    bool streams_answers = false;
    bool every_step = false; // whether a trajectory has every time step, not only the frames
    int threads = 1;         // threads for the reference; other implementations use one thread

    std::uint32_t packed() const
    {
        return unsigned{streams_answers} + 2 * unsigned{every_step} +
               4 * static_cast<std::uint32_t>(threads);
    }
    static SceneOptions unpacked(std::uint32_t word)
    {
        return {(word & 1) != 0, (word & 2) != 0, static_cast<int>(word >> 2)};
    }
};

/// The kinds of answers.
enum class ReplyStatus : std::uint32_t {
    done,            // the payload is the result
    not_implemented, // the payload is the text of NotImplemented
    not_finite,      // the payload says which quantity of the scene is not finite
    threw,           // the payload says what was thrown
    missing, // the payload is the index of a formula that the implementation does not define
    last = missing,
};

struct Channel {
    // Sizes [bytes].
    static constexpr std::size_t capacity = std::size_t{64} << 20; // only used pages take memory
    static constexpr std::size_t longest_text = 4096; // longest message about a failure

    alignas(64) std::atomic<std::uint32_t> request;
    std::atomic<Request> kind;
    std::atomic<std::uint32_t> argument;
    std::atomic<std::uint64_t> request_size;
    std::atomic<std::uint32_t>
        request_awaited; // not 0 while the worker may sleep until `request` changes
    // The formulas whose answers the client gives to a scene, 64 in each word.
    std::array<std::atomic<std::uint64_t>, (formula_count + 63) / 64> given_formulas;
    alignas(64) std::atomic<std::uint32_t> reply;
    std::atomic<ReplyStatus> status;
    std::atomic<std::uint64_t> reply_size;
    std::atomic<std::uint32_t> reply_awaited; // not 0 while the client may sleep
    Ring stream;                              // what a scene streams, from the worker
    Ring answers;                             // answers given to a scene, from the client
    std::byte payload[capacity];
};

/// A hash of the table of formulas (tags, names, names of arguments) and of the version of this
/// protocol. A worker with another hash is refused.
std::uint64_t contract_fingerprint();

/// Wakes the process that sleeps until the word changes, if there may be one.
/// @param awaited  not 0 if a process may be asleep
void wake(std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& awaited);

/// Sets the word and wakes the process that sleeps until it changes.
void post(std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& awaited,
          std::uint32_t value);

/// Allows this process to move to another processor when it shares one with the process for which
/// it waits. Only a client does: the walls forbid it to a worker.
void allow_moves();

/// A word of shared memory, and its value before the awaited change.
struct Until {
    const std::atomic<std::uint32_t>& word;
    std::uint32_t old;
};

/// Spins for a moment, then sleeps until the word is not `old` any more, until this process is
/// woken, or until `longest` has passed.
/// @param awaited  is 1 while this process may be asleep, otherwise 0
/// @param other    a second word; if it changes before this process sleeps, the wait ends too
/// @return the present value of the word
std::uint32_t await_change(std::atomic<std::uint32_t>& word, std::atomic<std::uint32_t>& awaited,
                           std::uint32_t old, std::chrono::nanoseconds longest,
                           const Until* other = nullptr);

} // namespace rigor
