// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <sys/stat.h>

int main(int argc, char** argv)
{
    // Whatever the umask is, nothing is made that every user may change.
    umask(umask(0) | S_IWOTH);
    return rigor::run_command_line(argc, argv, rigor::commands());
}
