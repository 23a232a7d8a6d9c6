// SPDX-License-Identifier: MIT
// The launcher `confine`: starts one program in a sandbox. It makes the namespaces and stays
// outside the rest of the sandbox as the monitor. It forks a child that puts up the sandbox around
// itself and becomes the program. The launcher is linked statically and does little else, so that
// to start a worker takes only milliseconds.
#include "sandbox/main/failure.hpp"
#include "sandbox/main/monitor.hpp"
#include "sandbox/main/namespaces.hpp"
#include "sandbox/main/options.hpp"
#include "sandbox/main/probe.hpp"
#include "sandbox/main/walls.hpp"

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

/// Starts the first process of a process namespace. This process only waits. When it ends, the
/// kernel ends all other processes of the namespace.
pid_t start_init()
{
    const pid_t init = must(fork(), "start the first process");
    if (init > 0) return init;
    leave_monitor();
    signal(SIGCHLD, SIG_IGN); // the kernel removes orphans that have ended
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close_range(0, ~0u, 0);
    for (;;)
        pause();
}

[[noreturn]] void launch(const Options& options)
{
    must(fcntl(report_socket, F_SETFD, FD_CLOEXEC), "keep the socket from the program");
    close_range(static_cast<unsigned>(report_socket) + 1, ~0u, 0);
    if (options.namespaces) enter_namespaces(options.user_namespace);
    become_monitor();
    const pid_t init = options.namespaces ? start_init() : 0;
    const pid_t program = must(fork(), "start a process");
    if (program == 0) {
        leave_monitor();
        become_program(options);
    }
    watch(program, init);
}

} // namespace

} // namespace rigor::confine

int main(int, char** arguments)
{
    using namespace rigor::confine;
    // The program, which may be another user, passes through the folders of its new root. Later
    // programs, which are others again, read what it writes, and none of them changes it.
    umask(022);
    const Options options = parse(arguments + 1);
    if (!options.probe) launch(options);
    probe(options);
}
