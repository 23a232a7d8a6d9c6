// SPDX-License-Identifier: MIT
// Starts a program in four steps. The launcher is spawned with the options for the sandbox. It
// reports that the sandbox is up, and sends the listener of blocked calls with it. If there is a
// listener and the program is a worker, the grader allows the one call that starts the program.
// Then the launcher's end of the socket closes, which shows that the program has started. To end
// the program, a signal is sent to the monitor, which ends the program and all that it started
// before it ends itself.
#include "sandbox/confined.hpp"

#include "sandbox/argument_pointers.hpp"
#include "sandbox/launcher.hpp"
#include "sandbox/notice_children.hpp"
#include "sandbox/report.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace {

[[noreturn]] void throw_errno(int error, const std::string& what)
{
    throw std::system_error(error, std::generic_category(), what);
}

void check(int result, const char* what)
{
    if (result < 0) throw_errno(errno, what);
}

void add_walls(std::vector<std::string>& options, const Walls& walls, unsigned user)
{
    if (walls.namespaces == Walls::Namespaces::plain) options.emplace_back("--namespaces=plain");
    if (walls.namespaces == Walls::Namespaces::user) options.emplace_back("--namespaces=user");
    if (walls.another_user) options.push_back(fmt::format("--user={}", user));
    if (walls.filter) options.emplace_back(walls.listener ? "--seccomp=notify" : "--seccomp=kill");
    if (walls.landlock) options.emplace_back("--landlock");
}

void add_limits(std::vector<std::string>& options, const ResourceLimits& limits, const Walls& walls)
{
    const auto add = [&](const char* name, std::optional<std::uint64_t> most) {
        if (most) options.push_back(fmt::format("--limit={}:{}", name, *most));
    };
    add("address_space", limits.address_space);
    add("processor_time", limits.processor_time);
    add("file_size", limits.file_size);
    add("open_files", limits.open_files);
    add("stack", limits.stack);
    if (can_limit_processes(walls)) add("processes", limits.processes);
}

/// The command line of the launcher, see `main/options.hpp`.
std::vector<std::string> command_line(const Confinement& confinement, std::size_t descriptors,
                                      const std::vector<std::string>& arguments, unsigned user)
{
    const Walls walls = walls_of(confinement.tier);
    std::vector<std::string> options = {launcher_path, fmt::format("--report={}", descriptors)};
    const bool is_compiler = confinement.profile == Profile::compiler;
    options.emplace_back(is_compiler ? "--profile=compiler" : "--profile=worker");
    add_walls(options, walls, user);
    add_limits(options, confinement.limits, walls);
    for (const auto& path : confinement.readable)
        options.push_back("--read=" + path.string());
    for (const auto& path : confinement.writable)
        options.push_back("--write=" + path.string());
    options.push_back("--folder=" + confinement.folder.string());
    options.emplace_back("--");
    options.insert(options.end(), arguments.begin(), arguments.end());
    return options;
}

/// The actions between fork and exec. The child gets these descriptors and no others. Its signals
/// have their default actions, and it is in a new session.
class SpawnPlan {
public:
    explicit SpawnPlan(std::span<const int> descriptors)
    {
        posix_spawn_file_actions_init(&actions_);
        for (std::size_t i = 0; i < descriptors.size(); ++i)
            posix_spawn_file_actions_adddup2(&actions_, descriptors[i], static_cast<int>(i));
        posix_spawn_file_actions_addclosefrom_np(&actions_, static_cast<int>(descriptors.size()));

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

    pid_t run(const std::vector<std::string>& arguments,
              const std::vector<std::string>& environment) const
    {
        pid_t pid = -1;
        const int error =
            posix_spawn(&pid, arguments[0].c_str(), &actions_, &attributes_,
                        argument_pointers(arguments).data(), argument_pointers(environment).data());
        if (error != 0) throw_errno(error, "cannot start " + arguments[0]);
        return pid;
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// The two ends of the socket for reports. The kernel adds to each report which process sent it.
struct Sockets {
    Sockets()
    {
        int both[2];
        check(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, both), "socketpair");
        grader = Descriptor(both[0], "socketpair");
        launcher = Descriptor(both[1], "socketpair");
        const int yes = 1;
        check(setsockopt(grader, SOL_SOCKET, SO_PASSCRED, &yes, sizeof yes), "SO_PASSCRED");
    }
    Descriptor grader, launcher;
};

struct Received {
    bool closed = false; // whether no more reports can come
    Report report = {};
    pid_t sender = -1;
    int listener = -1;
};

Received receive(int socket)
{
    Received received;
    iovec bytes = {&received.report, sizeof received.report};
    alignas(cmsghdr) char buffer[CMSG_SPACE(sizeof(ucred)) + CMSG_SPACE(sizeof(int))];
    msghdr message = {};
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    message.msg_control = buffer;
    message.msg_controllen = sizeof buffer;
    ssize_t n;
    while ((n = recvmsg(socket, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
    }
    received.closed = n != sizeof received.report;
    for (cmsghdr* part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
        if (part->cmsg_type == SCM_RIGHTS)
            std::memcpy(&received.listener, CMSG_DATA(part), sizeof received.listener);
        if (part->cmsg_type == SCM_CREDENTIALS) {
            ucred sender;
            std::memcpy(&sender, CMSG_DATA(part), sizeof sender);
            received.sender = sender.pid;
        }
    }
    return received;
}

/// Takes the next blocked call from a listener.
/// @return nothing if the process that made the call has ended
std::optional<seccomp_notif> next_call(int listener)
{
    seccomp_notif call = {};
    if (ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &call) != 0) return {};
    return call;
}

/// Waits for the call by which the launcher becomes the program, and lets it happen.
void allow_start(int listener, int reports)
{
    pollfd both[] = {{listener, POLLIN, 0}, {reports, POLLIN, 0}};
    while (poll(both, 2, -1) < 0 && errno == EINTR) {
    }
    if (!(both[0].revents & POLLIN)) return; // the launcher failed, and the next report says why
    const auto call = next_call(listener);
    if (!call || call->data.nr != SYS_execveat) return;
    seccomp_notif_resp answer = {};
    answer.id = call->id;
    answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &answer); // fails only if the launcher has died
}

/// Whether a program cannot be started for what is in its file. The other errors of this call are
/// about the machine as it is now.
bool is_fault_of_file(int error)
{
    return error == ENOEXEC || error == EINVAL || error == ELIBBAD || error == ENOENT ||
           error == ENOMEM || error == E2BIG;
}

bool ends_within(pid_t child, int milliseconds)
{
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
    if (handle < 0) return false;
    pollfd ended = {handle, POLLIN, 0};
    int result;
    // If a signal interrupts the wait, the wait starts again with the full time.
    while ((result = poll(&ended, 1, milliseconds)) < 0 && errno == EINTR) {
    }
    close(handle);
    return result > 0;
}

} // namespace

bool can_limit_processes(const Walls& walls)
{
    return walls.another_user || (walls.namespaces == Walls::Namespaces::user && geteuid() != 0);
}

void make_undumpable()
{
    check(prctl(PR_SET_DUMPABLE, 0), "PR_SET_DUMPABLE");
}

Confined::Confined(const Confinement& confinement, const std::vector<std::string>& arguments,
                   std::span<const int> descriptors, bool awaits)
    : path_(arguments[0])
{
    notice_children();
    try {
        start(confinement, arguments, descriptors);
    } catch (...) {
        end();
        throw;
    }
    if (awaits) await_start();
}

Confined::~Confined()
{
    end();
}

void Confined::start(const Confinement& confinement, const std::vector<std::string>& arguments,
                     std::span<const int> descriptors)
{
    const Walls walls = walls_of(confinement.tier);
    const unsigned user = walls.another_user ? unused_user() : 0;
    if (user != 0)
        for (const auto& path : confinement.writable)
            check(lchown(path.c_str(), user, user), path.c_str());

    Sockets sockets;
    std::vector<int> given(descriptors.begin(), descriptors.end());
    given.push_back(sockets.launcher);
    monitor_ = SpawnPlan(given).run(command_line(confinement, descriptors.size(), arguments, user),
                                    confinement.environment);
    sockets.launcher = {};
    reports_ = std::move(sockets.grader);
    asks_ = walls.listener && confinement.profile == Profile::worker;
}

void Confined::await_start()
{
    if (reports_ < 0) return;
    const Descriptor reports = std::move(reports_);
    const auto what = [&](const Received& failed) {
        return fmt::format("cannot start {}: {}", path_, failed.report.action);
    };
    const auto has_failed = [](const Received& received) {
        return !received.closed && received.report.error != 0;
    };
    try {
        const Received ready = receive(reports);
        if (ready.listener >= 0) listener_ = Descriptor(ready.listener, "listener");
        if (has_failed(ready)) throw_errno(ready.report.error, what(ready));
        if (ready.closed) throw_errno(ECHILD, "cannot start " + path_ + ": its launcher has died");
        program_ = ready.sender;
        if (asks_) allow_start(listener_, reports);
        const Received last = receive(reports); // the socket closes when the program starts
        if (has_failed(last) && is_fault_of_file(last.report.error))
            throw CannotRun(last.report.error, std::generic_category(), what(last));
        if (has_failed(last)) throw_errno(last.report.error, what(last));
    } catch (...) {
        end();
        throw;
    }
}

std::optional<int> Confined::blocked_call()
{
    if (blocked_ || listener_ < 0) return blocked_;
    pollfd waiting = {listener_, POLLIN, 0};
    if (poll(&waiting, 1, 0) == 1 && (waiting.revents & POLLIN))
        if (const auto call = next_call(listener_)) blocked_ = call->data.nr;
    return blocked_;
}

void Confined::begin_end()
{
    if (monitor_ <= 0) return;
    kill(monitor_, SIGTERM);
    kill(monitor_, SIGCONT);
}

rusage Confined::end()
{
    rusage used = {};
    if (monitor_ <= 0) return used;
    begin_end();
    constexpr int patience = 3000; // wait before SIGKILL [ms]: freeing memory may take time
    if (!ends_within(monitor_, patience)) kill(monitor_, SIGKILL);
    while (wait4(monitor_, nullptr, 0, &used) < 0 && errno == EINTR) {
    }
    monitor_ = -1;
    return used;
}

} // namespace rigor
