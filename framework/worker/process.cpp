// SPDX-License-Identifier: MIT
// Starts and ends a worker process. It is spawned with only a null input, a pipe for its output and
// the shared memory, in a session of its own and with limits on memory. Its output is read without
// waiting, and its whole process group is killed in the end.
#include "worker/process.hpp"

#include <array>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace rigor {

namespace {

[[noreturn]] void throw_errno(int error, const std::string& what)
{
    throw std::system_error(error, std::generic_category(), what);
}

int checked(int result, const char* what)
{
    if (result < 0) throw_errno(errno, what);
    return result;
}

/// A descriptor that closes itself. Its number is higher than those that a worker gets, so that
/// none is overwritten when the child's descriptors are put in place.
class Descriptor {
public:
    explicit Descriptor(int low) : fd_(checked(fcntl(low, F_DUPFD_CLOEXEC, 10), "descriptor"))
    {
        close(low);
    }
    ~Descriptor()
    {
        if (fd_ >= 0) close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    operator int() const { return fd_; }
    int release() { return std::exchange(fd_, -1); }

private:
    int fd_;
};

/// Shared memory that nobody can shrink, so that reading it never fails.
int shared_memory()
{
    const int fd = checked(memfd_create("worker", MFD_CLOEXEC | MFD_ALLOW_SEALING), "memfd_create");
    checked(ftruncate(fd, sizeof(Channel)), "ftruncate");
    checked(fcntl(fd, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL), "seal");
    return fd;
}

/// The actions between fork and exec: the child gets descriptors 0 to 3 and no other, default
/// signals and a new session.
class SpawnPlan {
public:
    SpawnPlan(int output, int memory)
    {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, output, 1);
        posix_spawn_file_actions_adddup2(&actions_, output, 2);
        posix_spawn_file_actions_adddup2(&actions_, memory, 3);
        posix_spawn_file_actions_addclosefrom_np(&actions_, 4);

        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK |
                                                   POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
    }
    ~SpawnPlan()
    {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    int run(const std::string& executable) const
    {
        // The worker compares this with its parent's id, to notice that the client died before the
        // worker could ask to be told of its death.
        std::string program = executable, parent = std::to_string(getpid());
        std::array<char*, 3> arguments = {program.data(), parent.data(), nullptr};
        // A sanitizer's report ends the process by SIGABRT. Other signals are not changed.
        std::string path = "PATH=/usr/bin:/bin", language = "LANG=C.UTF-8",
                    address = "ASAN_OPTIONS=abort_on_error=1:handle_segv=0:handle_sigbus=0:"
                              "handle_abort=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0:"
                              "allocator_may_return_null=1",
                    undefined = "UBSAN_OPTIONS=abort_on_error=1:print_stacktrace=1";
        std::array<char*, 5> environment = {path.data(), language.data(), address.data(),
                                            undefined.data(), nullptr};
        pid_t pid = -1;
        const int error = posix_spawn(&pid, executable.c_str(), &actions_, &attributes_,
                                      arguments.data(), environment.data());
        if (error != 0) throw_errno(error, "cannot start " + executable);
        return pid;
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// Makes the ends of child processes visible: a program that was started with SIGCHLD ignored would
/// never learn how its children ended.
void notice_children()
{
    struct sigaction now {};
    if (sigaction(SIGCHLD, nullptr, &now) == 0 && now.sa_handler == SIG_IGN)
        signal(SIGCHLD, SIG_DFL);
}

void limit(int pid, __rlimit_resource resource, std::size_t most)
{
    const rlimit both = {most, most};
    prlimit(pid, resource, &both, nullptr); // an error is ignored: the process has ended
}

std::string signal_name(int signal)
{
    switch (signal) {
    case SIGSEGV:
        return "segmentation fault";
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
    default:
        break;
    }
    const char* name = sigabbrev_np(signal);
    return name ? "signal SIG" + std::string(name) : "signal " + std::to_string(signal);
}

} // namespace

Process::Process(const std::filesystem::path& executable, const Limits& limits)
{
    notice_children();
    const Descriptor memory(shared_memory());
    std::array<int, 2> ends{};
    checked(pipe2(ends.data(), O_CLOEXEC), "pipe");
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);
    checked(fcntl(ours, F_SETFL, O_NONBLOCK), "pipe");

    void* address = mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
    if (address == MAP_FAILED) throw_errno(errno, "mmap");
    try {
        pid_ = SpawnPlan(theirs, memory).run(executable);
    } catch (...) {
        munmap(address, sizeof(Channel));
        throw;
    }
    channel_ = static_cast<Channel*>(address);
    output_ = ours.release();

    // A sanitizer reserves terabytes of addresses that it never touches. It also switches core
    // files off itself when it starts, and gives up if somebody else does so at that moment.
    if (is_sanitized) return;
    limit(pid_, RLIMIT_CORE, 0);
    limit(pid_, RLIMIT_AS, limits.memory);
}

Process::~Process()
{
    kill(-pid_, SIGKILL); // first its group, while the leader still holds the number
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    munmap(channel_, sizeof(Channel));
    close(output_);
}

std::optional<Broken> Process::ending() const
{
    siginfo_t info{};
    // WNOWAIT leaves a zombie, so that its number is not used again until the destructor has killed
    // its group.
    if (waitid(P_PID, pid_, &info, WEXITED | WSTOPPED | WNOHANG | WNOWAIT) != 0)
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

std::chrono::nanoseconds Process::time_without_processor() const
{
    // The numbers of the main thread, see proc(5): time on a processor, time waiting for one [ns],
    // number of time slices.
    std::ifstream file("/proc/" + std::to_string(pid_) + "/schedstat");
    std::int64_t with = 0, without = 0;
    file >> with >> without; // both stay 0 if the kernel does not tell
    return std::chrono::nanoseconds(without);
}

std::size_t Process::drain(std::string& kept, std::size_t keep)
{
    std::array<char, 65536> buffer;
    const ssize_t n = read(output_, buffer.data(), buffer.size());
    if (n <= 0) return 0; // nothing to read now, or the pipe is closed
    if (kept.size() < keep)
        kept.append(buffer.data(), std::min<std::size_t>(n, keep - kept.size()));
    return n;
}

} // namespace rigor
