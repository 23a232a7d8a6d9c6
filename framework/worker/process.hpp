// SPDX-License-Identifier: MIT
// One worker process from start to end: its memory, its output, its death.
#pragma once

#include "sandbox/confined.hpp"
#include "worker/failure.hpp"
#include "worker/protocol/channel.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace rigor {

#ifdef RIGOR_SANITIZED
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif
/// A factor for time limits. It is larger than the slowdown of a scene by a sanitizer.
inline constexpr double sanitizer_factor = is_sanitized ? 20 : 1;

/// Whose formulas a worker runs. It decides which walls there are around it.
enum class Trust {
    ours,     // the reference, or scenes of the author's own code: limits on resources only
    students, // formulas that are graded: the walls of the usual tier; needs a static worker
};

/// The limits of an implementation. The oracle is a second worker, which runs the reference. A time
/// limit is the greater of its floor and `multiple` times the time that the oracle took for the
/// same request; without an oracle it is the floor. Time counts from the request, while the client
/// waits and the worker is on a processor or sleeps. While the worker waits for a processor on a
/// busy machine, a tenth of the time counts.
struct Limits {
    Trust trust = Trust::ours;
    std::chrono::duration<double> start{10}; // from exec until the worker is ready
    // Floor for a formula, or 256 kB of states to advance. Even under a sanitizer no formula comes
    // near it.
    std::chrono::duration<double> call{2};
    std::chrono::duration<double> scene{20 * sanitizer_factor}; // floor for a whole scene
    /// Whether a scene's limit is for the time between two records instead of the whole scene. This
    /// is for scenes that someone watches.
    bool scene_by_silence = false;
    std::chrono::duration<double> oracle{60 * sanitizer_factor}; // limit for the oracle itself
    double multiple = 50;
    /// The free time for all calls of formulas together, and for all scenes together. When it is
    /// used up, the floors are a tenth, see `TimeBudget`. The reference needs less than one second
    /// for the calls of any assignment, and less than five for its scenes.
    std::chrono::duration<double> all_calls{8 * sanitizer_factor},
        all_scenes{20 * sanitizer_factor};
    std::size_t memory = std::size_t{2} << 30; // address space [bytes]; unlimited under a sanitizer
    std::size_t output = std::size_t{1} << 20; // what a request may print [bytes]
    std::size_t trajectory = std::size_t{1} << 30; // what a scene may stream [bytes]
    std::size_t output_kept = 4096;                // kept beginning of the output [bytes]
};

/// Why a process cannot be used any more.
struct Broken {
    WorkerFailure::Cause cause;
    std::string text; // "crashed: segmentation fault"
};

/// A child process with a `Channel`, behind the walls that its `Trust` asks for. It inherits no
/// descriptor except a null input, its end of the output pipe and the shared memory, and hardly any
/// environment. It dies with the thread that started it, and ending it ends all that it started.
class Process {
public:
    /// Starts the executable and does not wait for that: `await_start` comes before anything else.
    /// @throws std::system_error if its launcher cannot be started
    Process(const std::filesystem::path& executable, const Limits& limits);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits until the executable runs; it may not be ready yet.
    /// @throws std::system_error if it cannot be started behind these walls
    void await_start() { program_.await_start(); }

    /// Begins to end it and does not wait; the destructor does.
    void begin_end() { program_.begin_end(); }

    Channel& channel() { return *channel_; }

    /// How it ended or stopped; empty while it runs.
    std::optional<Broken> ending();

    /// What it has done so far, as the kernel tells; nothing if it does not.
    struct Progress {
        std::chrono::nanoseconds on_processor{0}; // time that it has computed
        bool sleeps = false; // it waits for something, and neither computes nor wants to
    };
    std::optional<Progress> progress() const;

    /// Reads what it has printed so far and appends up to `keep` bytes in all to `kept`.
    /// @return the number of bytes read
    std::size_t drain(std::string& kept, std::size_t keep);

private:
    Ends output_ = output_pipe();
    Descriptor memory_;
    Confined program_;
    Channel* channel_ = nullptr;
};

} // namespace rigor
