// SPDX-License-Identifier: MIT
// One worker process from start to end: the memory that it shares with its client, its output, and
// how it ended.
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
/// Most time limits are multiplied by this factor, see `Limits`. It is larger than the slowdown of
/// a scene by a sanitizer.
inline constexpr double sanitizer_factor = is_sanitized ? 20 : 1;

/// Whose formulas a worker runs. This decides which walls (parts of the sandbox) are around it.
enum class Trust {
    // The reference, or code that its own author runs: limits on resources only.
    ours,
    // Formulas that are graded: the sandbox of `usual_tier`. In tiers A and B a worker that is not
    // linked statically does not start, since it cannot open its libraries.
    students,
};

/// The limits of an implementation. The oracle is a second worker, which runs the reference. The
/// limit of a call or of a scene is the time that the oracle took for the same request, times the
/// factor `multiple`, but at least a lowest value, its floor. Without an oracle, the limit is the
/// floor. Time counts from the request on, while the client waits and the worker is on a processor
/// or sleeps. If the machine is busy and the worker waits for a processor, at most a tenth of that
/// time counts.
struct Limits {
    Trust trust = Trust::ours;
    std::chrono::duration<double> start{10}; // limit from exec until the worker is ready
    // The floor for a call of a formula, or for advancing 256 kB of states. No formula takes nearly
    // as long, even in a build with a sanitizer.
    std::chrono::duration<double> call{2};
    std::chrono::duration<double> scene{20 * sanitizer_factor}; // floor for a whole scene
    /// Whether a scene's limit is for each wait between two parts of its stream, instead of for the
    /// whole scene. This is for a scene that a person watches while it runs.
    bool scene_by_silence = false;
    // The limit for a request to the oracle.
    std::chrono::duration<double> oracle{60 * sanitizer_factor};
    double multiple = 50;
    /// How long all calls of formulas together, and all scenes together, may take before the floors
    /// `call` and `scene` are reduced to a tenth of their values, see `TimeBudget`. The reference
    /// needs less than one second for the calls of any assignment, and less than five seconds for
    /// the scenes of any assignment.
    std::chrono::duration<double> all_calls{8 * sanitizer_factor},
        all_scenes{20 * sanitizer_factor};
    /// How long all starts together may take, and the limit for each further start once this time
    /// is used up. A start usually takes a few milliseconds.
    std::chrono::duration<double> all_starts{10 * sanitizer_factor},
        late_start{0.25 * sanitizer_factor};
    /// Limit on the address space [bytes]. In a build with a sanitizer, workers with `Trust::ours`
    /// do not have this limit.
    std::size_t memory = std::size_t{2} << 30;
    std::size_t output = std::size_t{1} << 20;     // how much a request may print [bytes]
    std::size_t trajectory = std::size_t{1} << 30; // longest streamed trajectory [bytes]
    std::size_t output_kept = 4096; // how much of the output is kept, from its beginning [bytes]
};

/// Why a process cannot be used any more.
struct Broken {
    WorkerFailure::Cause cause;
    std::string text; // such as "crashed: segmentation fault"
};

/// A child process with a `Channel`, in a sandbox with the walls that its `Trust` asks for. The
/// only descriptors that it inherits are /dev/null as its input, its end of the output pipe and
/// the shared memory. Its environment is empty, or in a build with sanitizers has only their
/// options. It dies with the thread that started it. When it is ended, all processes that it
/// started are ended too.
class Process {
public:
    /// Begins to start the executable, without waiting until it runs. The caller then calls
    /// `await_start`: without this call the executable may never run.
    /// @throws std::system_error if the launcher of the sandbox cannot be started
    Process(const std::filesystem::path& executable, const Limits& limits);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits until the executable runs. It may not be ready for requests yet.
    /// @throws std::system_error if the executable cannot be started in this sandbox
    void await_start() { program_.await_start(); }

    /// Begins to end the process, without waiting for its end. The destructor waits.
    void begin_end() { program_.begin_end(); }

    Channel& channel() { return *channel_; }

    /// How the process ended or stopped; empty while it runs.
    std::optional<Broken> ending();

    /// What the process has done so far, as /proc tells it. `progress` returns nothing if /proc
    /// does not tell.
    struct Progress {
        std::chrono::nanoseconds on_processor{0}; // time that its main thread was on a processor
        // Time that its main thread and the calling thread of this process waited for a processor.
        std::chrono::nanoseconds waited_to_run{0};
        bool sleeps = false; // whether it neither runs, nor waits for a processor or a disk
    };
    std::optional<Progress> progress() const;

    /// The time that all threads of the process were on a processor [s]; 0 if it has ended.
    std::chrono::duration<double> on_processor() const;

    /// Reads a part of what the process has printed, and appends it to `kept`, but only until
    /// `kept` has `keep` bytes.
    /// @return the number of bytes read; 0 if there is nothing to read now or the pipe is closed
    std::size_t drain(std::string& kept, std::size_t keep);

private:
    Ends output_ = output_pipe();
    Descriptor memory_;
    Confined program_;
    Channel* channel_ = nullptr;
};

} // namespace rigor
