// SPDX-License-Identifier: MIT
// A program in a sandbox, from start to end. The parts of the sandbox are called walls, such as a
// filter of system calls.
//
// The grader starts the launcher `confine`. The launcher stays outside the walls as the monitor.
// Its child puts up the walls around itself and becomes the program. The monitor ends in the way in
// which the program ends, and nothing that the program started outlives the monitor. If the grader
// has a listener (a descriptor through which the kernel reports blocked system calls), a blocked
// call waits for the grader, who learns which call it is. The program never gets an answer. Without
// a listener, a blocked call ends the process that makes it.
#pragma once

#include "sandbox/descriptor.hpp"
#include "sandbox/tier.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <system_error>
#include <vector>

namespace rigor {

/// The kind of a program. In tier C, where a program has limits on resources only (tier.hpp), both
/// kinds are limited in the same way.
enum class Profile {
    worker,  // a static program that computes: it opens and starts nothing
    compiler // a program that reads and starts files of /usr and of `Confinement::readable`
};

/// Limits for each process. If a limit has no value here, only the system's limit for the user
/// holds.
struct ResourceLimits {
    std::optional<std::uint64_t> address_space;  // [bytes]
    std::optional<std::uint64_t> processor_time; // [s]
    std::optional<std::uint64_t> file_size;      // [bytes]
    std::optional<std::uint64_t> open_files;
    std::optional<std::uint64_t> stack; // [bytes]
    /// Number of processes and threads of the user. This limit is used only if
    /// `can_limit_processes`.
    std::optional<std::uint64_t> processes;
};

struct Confinement {
    Profile profile;
    Tier tier; // usual_tier() for programs that students wrote
    /// For a compiler: the paths whose files it may read and start, and the paths that it may
    /// change. Namespaces or Landlock keep it from all other paths, besides those of the
    /// system. In a sandbox with neither of the two it reaches every path that its user reaches. If
    /// it runs as another user, that user becomes the owner of the writable paths, and the readable
    /// paths must be readable for everybody.
    std::vector<std::filesystem::path> readable = {}, writable = {};
    std::filesystem::path folder = "/";        // the program's working directory
    std::vector<std::string> environment = {}; // "NAME=value" for each variable
    ResourceLimits limits = {};
};

/// Whether the number of processes can be limited behind these walls. The kernel counts all
/// processes of a user, also those outside of the sandbox. So the program needs a user or a user
/// namespace of its own. The kernel never limits root.
bool can_limit_processes(const Walls& walls);

/// Keeps other processes of the same user, unless the user is root, from looking at the
/// memory, the descriptors and the environment of this process (`/proc/PID/mem`, `fd`, `environ`).
void make_undumpable();

/// The system refuses to run a program in a sandbox that is up: its file is at fault.
struct CannotRun : std::system_error {
    using std::system_error::system_error;
};

class Confined {
public:
    /// Starts a program. `arguments` begins with the path of the program. `descriptors` become the
    /// program's descriptors 0, 1, …; it has no other descriptors.
    /// @param awaits  whether to wait until the program runs; otherwise the caller calls
    ///                `await_start` later
    /// @throws std::system_error if the program cannot be started in this sandbox
    Confined(const Confinement& confinement, const std::vector<std::string>& arguments,
             std::span<const int> descriptors, bool awaits = true);
    /// Ends the program and all that it started.
    ~Confined();
    Confined(const Confined&) = delete;
    Confined& operator=(const Confined&) = delete;

    /// Waits until the program runs. With a listener of blocked calls, a worker does not start
    /// before this call: its launcher puts up the sandbox and then waits for permission to go on.
    /// @throws CannotRun, std::system_error if the program cannot be started in this sandbox
    void await_start();

    /// The process id of the monitor, the process that watches the program from outside. The
    /// monitor ends in the same way as the program (with 0 after SIGTERM, which asks it to end the
    /// program), and is stopped by a signal when the program is.
    pid_t monitor() const { return monitor_; }

    /// The process id of the program; -1 before `await_start` has returned. Use it only to observe
    /// the program, in `/proc` or by the clock of its processor time: after the program's end,
    /// another process may get this id.
    pid_t program() const { return program_; }

    /// The number of the first blocked system call; empty if there was none, or if there is no
    /// listener. The process that made the call, the program or one that it started, waits forever.
    /// Without a listener it is killed by SIGSYS instead.
    std::optional<int> blocked_call();

    /// A descriptor that becomes readable when a call was blocked; -1 if there is no listener.
    int listener() const { return listener_; }

    /// Begins to end the program and all that it started, without waiting for their end.
    void begin_end();
    /// Ends the program and all that it started. @return the resources that they used
    rusage end();

private:
    void start(const Confinement& confinement, const std::vector<std::string>& arguments,
               std::span<const int> descriptors);

    pid_t monitor_ = -1, program_ = -1;
    Descriptor listener_;
    Descriptor reports_; // the socket to the launcher, until the program runs
    std::string path_;   // the path of the program
    bool asks_ = false;  // whether the start of the program waits for the grader
    std::optional<int> blocked_;
};

} // namespace rigor
