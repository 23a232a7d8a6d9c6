// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

int main(int argc, char** argv)
{
    return rigor::run_command_line(argc, argv, rigor::commands());
}
