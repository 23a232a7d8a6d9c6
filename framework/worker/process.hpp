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
    ours,     // the reference, or code that its own author runs: limits on resources only
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
    // Floor for a call of a formula, or for advancing 256 kB of states. Even under a sanitizer no
    // formula takes nearly as long.
    std::chrono::duration<double> call{2};
    std::chrono::duration<double> scene{20 * sanitizer_factor}; // floor for a whole scene
    /// Whether a scene's limit is for the time between two records instead of the whole scene. This
    /// is for scenes that someone watches.
    bool scene_by_silence = false;
    std::chrono::duration<double> oracle{60 * sanitizer_factor}; // limit for the oracle itself
    double multiple = 50;
    /// How long all calls of formulas together, and all scenes together, may take before the floors
    /// `call` and `scene` are reduced to a tenth, see `TimeBudget`. The reference needs less than
    /// one second for the calls of any assignment, and less than five for its scenes.
    std::chrono::duration<double> all_calls{8 * sanitizer_factor},
        all_scenes{20 * sanitizer_factor};
    /// Limit on the address space [bytes]. Our own workers have none under a sanitizer.
    std::size_t memory = std::size_t{2} << 30;
    std::size_t output = std::size_t{1} << 20;     // what a request may print [bytes]
    std::size_t trajectory = std::size_t{1} << 30; // what a scene may stream [bytes]
    std::size_t output_kept = 4096;                // how much of its beginning is kept [bytes]
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
    /// Begins to start the executable, without waiting until it runs. `await_start` must be called
    /// before the process is used.
    /// @throws std::system_error if its launcher cannot be started
    Process(const std::filesystem::path& executable, const Limits& limits);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits until the executable runs. It may not be ready for requests yet.
    /// @throws std::system_error if it cannot be started behind these walls
    void await_start() { program_.await_start(); }

    /// Begins to end the process, without waiting for its end. The destructor waits.
    void begin_end() { program_.begin_end(); }

    Channel& channel() { return *channel_; }

    /// How it ended or stopped; empty while it runs.
    std::optional<Broken> ending();

    /// What the process has done so far, as the kernel tells it. `progress` returns nothing if the
    /// kernel does not tell.
    struct Progress {
        std::chrono::nanoseconds on_processor{0}; // time that it has computed
        bool sleeps = false; // whether it waits for something other than a processor
    };
    std::optional<Progress> progress() const;

    /// Reads a part of what the process has printed, and appends it to `kept` as far as that has
    /// less than `keep` bytes.
    /// @return the number of bytes read; 0: nothing to read now, or the pipe is closed
    std::size_t drain(std::string& kept, std::size_t keep);

private:
    Ends output_ = output_pipe();
    Descriptor memory_;
    Confined program_;
    Channel* channel_ = nullptr;
};

} // namespace rigor
