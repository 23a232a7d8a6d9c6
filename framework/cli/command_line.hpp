// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands.hpp"

namespace rigor {

/// Reads the command line and runs its command, which is one of `commands`. A command of the
/// program `rigor_class` is left to that program, which is built first if it is out of date.
/// @return the exit status
int run_command_line(int argc, char** argv, std::span<const CommandEntry> commands);

} // namespace rigor
