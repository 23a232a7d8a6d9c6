// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// Reads the command line and runs its command. @return the exit status
int run_command_line(int argc, char** argv);

} // namespace rigor
