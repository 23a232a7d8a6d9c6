// SPDX-License-Identifier: MIT
// One worker process, from start to end: its memory, its output, its death.
#pragma once

#include "worker/channel.hpp"
#include "worker/failure.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace rigor {

#ifdef RIGOR_SANITIZED
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif
/// What a sanitizer slows a scene down by, and more.
inline constexpr double patience = is_sanitized ? 20 : 1;

/// What an implementation may use. A limit on time is the greater of its floor and `multiple` times
/// what the oracle took for the same request; without an oracle it is the floor. Time runs from the
/// request, while its client waits and the worker has a processor or sleeps: what a busy machine
/// takes counts a tenth.
struct Limits {
    std::chrono::duration<double> start{10}; // from exec until it is ready
    std::chrono::duration<double> call{2};   // floor for a formula, or 256 kB of states to advance
    std::chrono::duration<double> scene{20 * patience}; // floor for a whole scene
    bool scene_by_silence = false; // a scene's limit is for a record, not for all: someone watches
    std::chrono::duration<double> oracle{60 * patience}; // for the oracle's own run
    double multiple = 50;
    std::size_t memory = std::size_t{2} << 30; // address space [bytes]; unlimited under a sanitizer
    std::size_t output = std::size_t{1} << 20; // a request may print [bytes]
    std::size_t trajectory = std::size_t{1} << 30; // a scene may stream [bytes]
    std::size_t output_kept = 4096;                // the beginning of the output, to show [bytes]
};

/// Why a process is of no use any more.
struct Broken {
    WorkerFailure::Cause cause;
    std::string text; // "crashed: segmentation fault"
};

/// A child process with a `Channel`. It runs in a session of its own, with no descriptor of ours
/// but its end of the output pipe, with hardly an environment, and dies with the thread that
/// started it. Ending it ends every process of its group. What runs under our user can still harm
/// us in ways only a sandbox prevents (signals to us, files): this class is no sandbox.
class Process {
public:
    /// Starts the executable; does not wait until it is ready.
    /// @throws std::system_error if it cannot be started
    Process(const std::filesystem::path& executable, const Limits& limits);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    Channel& channel() { return *channel_; }

    /// How it ended or stopped; empty: it runs.
    std::optional<Broken> ending() const;

    /// How long it was ready to run so far but other processes had the processors.
    std::chrono::nanoseconds time_without_processor() const;

    /// Takes what it has printed so far. @return bytes taken
    std::size_t drain(std::string& kept, std::size_t keep);

private:
    int pid_ = -1;
    int output_ = -1;
    Channel* channel_ = nullptr;
};

} // namespace rigor
