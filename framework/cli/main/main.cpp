// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <csignal>
#include <sys/stat.h>

int main(int argc, char** argv)
{
    // If whoever starts this program ignores the end of children, so would this program, and it
    // would never learn how a compiler or a worker ended.
    std::signal(SIGCHLD, SIG_DFL);
    // Whatever the umask is, nothing is made that every user may change.
    umask(umask(0) | S_IWOTH);
    return rigor::run_command_line(argc, argv);
}
