// SPDX-License-Identifier: MIT
// Starts and ends a worker process. The launcher starts it with only /dev/null as its input, a pipe
// for its output and the shared memory, and with limits on its resources. Its output is read
// without waiting. The monitor of its sandbox ends it and all that it started.
#include "worker/process.hpp"

#include "sandbox/blocked_calls.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace {

int checked(int result, const char* what)
{
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
    return result;
}

/// Shared memory that nobody can shrink, so that reading it never fails.
Descriptor shared_memory()
{
    Descriptor memory(memfd_create("worker", MFD_CLOEXEC | MFD_ALLOW_SEALING), "memfd_create");
    checked(ftruncate(memory, sizeof(Channel)), "ftruncate");
    checked(fcntl(memory, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL), "seal");
    return memory;
}

ResourceLimits resources(const Limits& limits)
{
    ResourceLimits resources;
    // A sanitizer reserves terabytes of addresses and never uses most of them.
    if (!is_sanitized || limits.trust == Trust::students) resources.address_space = limits.memory;
    // 32 MB are enough for a recursion over 100 000 stacked bodies, which is deep but not wrong.
    resources.stack = std::size_t{32} << 20;
    if (limits.trust == Trust::students) {
        resources.file_size = 0;
        resources.open_files = 16; // not 0, since the launcher needs some descriptors
        resources.processes = 0;
    }
    return resources;
}

// Lets other users start the executable, because a worker runs as another user if root grades. A
// build under a strict umask does not give this permission.
void let_others_start(const std::filesystem::path& executable)
{
    using std::filesystem::perms;
    std::error_code error; // ignored: if the worker cannot start then, its start fails
    std::filesystem::permissions(executable, perms::group_exec | perms::others_exec,
                                 std::filesystem::perm_options::add, error);
}

Confinement confinement(const std::filesystem::path& executable, const Limits& limits)
{
    if (limits.trust == Trust::students && geteuid() == 0) let_others_start(executable);
    Confinement walls{Profile::worker, limits.trust == Trust::ours ? Tier::c : usual_tier()};
    walls.limits = resources(limits);
    // A sanitizer's report ends the process by SIGABRT. Other signals end it as usual.
    if (is_sanitized)
        walls.environment = {"ASAN_OPTIONS=abort_on_error=1:handle_segv=0:handle_sigbus=0:"
                             "handle_abort=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0:"
                             "allocator_may_return_null=1",
                             "UBSAN_OPTIONS=abort_on_error=1:print_stacktrace=1"};
    return walls;
}

std::string signal_name(int signal)
{
    switch (signal) {
    case SIGSEGV:
        return "segmentation fault, such as by an index outside of a list or endless recursion";
    case SIGABRT:
        return "aborted";
    case SIGFPE:
        return "arithmetic exception, such as an integer divided by zero";
    case SIGILL:
        return "illegal instruction, such as a function that returns no value";
    case SIGBUS:
        return "bus error";
    case SIGKILL:
        return "killed, perhaps out of memory";
    case SIGSYS:
        return "a system call that is not allowed here";
    default:
        break;
    }
    const char* name = sigabbrev_np(signal);
    return name ? "signal SIG" + std::string(name) : "signal " + std::to_string(signal);
}

} // namespace

Process::Process(const std::filesystem::path& executable, const Limits& limits)
    : memory_(shared_memory()),
      program_(confinement(executable, limits), {executable.string()},
               std::array<int, 4>{no_input(), output_.write, output_.write, memory_}, false)
{
    output_.write = {};
    void* address = mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
    if (address == MAP_FAILED) checked(-1, "mmap");
    channel_ = static_cast<Channel*>(address);
    memory_ = {};
}

Process::~Process()
{
    program_.end();
    munmap(channel_, sizeof(Channel));
}

std::optional<Broken> Process::ending()
{
    if (const std::optional<int> call = program_.blocked_call())
        return Broken{WorkerFailure::crashed, "tried to " + words_for_blocked_call(*call)};
    siginfo_t info{};
    // With WNOWAIT the monitor remains a zombie until `Confined::end` waits for it.
    if (waitid(P_PID, program_.monitor(), &info, WEXITED | WSTOPPED | WNOHANG | WNOWAIT) != 0)
        return Broken{WorkerFailure::crashed, "disappeared"};
    if (info.si_pid == 0) return {};
    switch (info.si_code) {
    case CLD_EXITED:
        return Broken{WorkerFailure::exited,
                      "ended the program: exit status " + std::to_string(info.si_status)};
    case CLD_STOPPED:
    case CLD_TRAPPED:
        return Broken{WorkerFailure::crashed, "stopped itself: " + signal_name(info.si_status)};
    default:
        return Broken{WorkerFailure::crashed, "crashed: " + signal_name(info.si_status)};
    }
}

std::optional<Process::Progress> Process::progress() const
{
    const std::string folder = "/proc/" + std::to_string(program_.program());
    // A thread's time on a processor and the time that it waited for one [ns], see the kernel's
    // sched-stats.rst. The second number grows only when the waiting is over.
    std::ifstream times(folder + "/schedstat"), own("/proc/thread-self/schedstat");
    std::int64_t on_processor = 0, waited = 0, own_on_processor = 0, own_waited = 0;
    // The state of the process is the letter after its name. The name is in brackets and may have
    // spaces.
    std::ifstream status(folder + "/stat");
    std::string line;
    std::getline(status, line);
    const std::size_t name_end = line.rfind(") ");
    if (!(times >> on_processor >> waited) || !(own >> own_on_processor >> own_waited) ||
        name_end == std::string::npos)
        return {};
    const char state = line[name_end + 2];
    return Progress{std::chrono::nanoseconds(on_processor),
                    std::chrono::nanoseconds(waited + own_waited), state != 'R' && state != 'D'};
}

std::chrono::duration<double> Process::on_processor() const
{
    clockid_t clock{};
    timespec time{};
    const pid_t program = program_.program();
    if (program <= 0 || clock_getcpuclockid(program, &clock) != 0 ||
        clock_gettime(clock, &time) != 0)
        return {};
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::size_t Process::drain(std::string& kept, std::size_t keep)
{
    std::array<char, 65536> buffer;
    const ssize_t n = read(output_.read, buffer.data(), buffer.size());
    if (n <= 0) return 0; // nothing to read now, or the pipe is closed
    if (kept.size() < keep)
        kept.append(buffer.data(), std::min<std::size_t>(n, keep - kept.size()));
    return n;
}

} // namespace rigor
