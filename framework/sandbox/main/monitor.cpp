// SPDX-License-Identifier: MIT
// Waits for the end of the program and ends all that it started. The kernel gives orphans to the
// nearest ancestor that has asked for them, so every descendant becomes a child of the monitor when
// its parents have died, whatever its session is. The monitor kills its children until it has none.
// If there is a process namespace, it is enough to kill the first process in it.
#include "sandbox/main/monitor.hpp"

#include "sandbox/main/failure.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

sigset_t awaited()
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGCHLD);
    return signals;
}

// The kernel's list of the children of this process: process ids with spaces between them.
std::string list_of_children()
{
    const std::string path = "/proc/self/task/" + std::to_string(getpid()) + "/children";
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::string text;
    char buffer[4096];
    for (ssize_t n; file >= 0 && (n = read(file, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(n));
    if (file >= 0) close(file);
    return text;
}

void kill_children()
{
    const std::string list = list_of_children();
    char* rest = nullptr;
    for (const char* at = list.c_str();; at = rest) {
        const long child = std::strtol(at, &rest, 10);
        if (rest == at) return;
        kill(static_cast<pid_t>(child), SIGKILL);
    }
}

void end_descendants(pid_t program, pid_t init)
{
    if (init > 0) kill(init, SIGKILL);
    if (program > 0) kill(-program, SIGKILL); // the program's group: most of its processes
    for (;;) {
        kill_children();
        pid_t ended;
        while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) {
        }
        if (ended < 0 && errno == ECHILD) return;
        usleep(200); // a killed process takes a moment to end
    }
}

// Ends this process in the way in which the program ended.
[[noreturn]] void end_like(int status)
{
    if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
    const rlimit core = {no_core, no_core};
    setrlimit(RLIMIT_CORE, &core);
    const int signal = WTERMSIG(status);
    std::signal(signal, SIG_DFL);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    sigprocmask(SIG_UNBLOCK, &only, nullptr);
    raise(signal);
    _exit(128 + signal);
}

// Stops this process, since the program has stopped itself. It ends the program before that: once
// stopped, it could not do so if the grader is killed. The kernel then ends this process.
void stop_like(pid_t program, pid_t init)
{
    end_descendants(program, init);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t pending;
    sigpending(&pending);
    if (sigismember(&pending, SIGTERM) == 1) _exit(0); // the grader has died already, or ends this
    raise(SIGSTOP);
}

// Collects the children that have ended. If the program is among them, this process ends too.
void collect_children(pid_t program, pid_t init)
{
    int status = 0;
    for (pid_t child; (child = waitpid(-1, &status, WNOHANG | WUNTRACED)) > 0;) {
        if (child != program) continue;
        if (WIFSTOPPED(status)) {
            stop_like(program, init);
            continue;
        }
        end_descendants(0, init); // not `program`: its process id may be in use again
        end_like(status);
    }
}

} // namespace

void become_monitor()
{
    must(prctl(PR_SET_CHILD_SUBREAPER, 1), "become the parent of orphans");
    const sigset_t signals = awaited();
    must(sigprocmask(SIG_BLOCK, &signals, nullptr), "block signals");
    must(prctl(PR_SET_PDEATHSIG, SIGTERM), "end with the grader");
}

void leave_monitor()
{
    const sigset_t signals = awaited();
    must(sigprocmask(SIG_UNBLOCK, &signals, nullptr), "unblock signals");
}

void watch(pid_t program, pid_t init)
{
    // The grader sees the end of the program's output only when nobody else can write to it.
    close_range(0, ~0u, 0);
    const sigset_t signals = awaited();
    for (;;) {
        int signal = 0;
        sigwait(&signals, &signal);
        if (signal == SIGTERM) {
            end_descendants(program, init);
            _exit(0);
        }
        collect_children(program, init);
    }
}

} // namespace rigor::confine
