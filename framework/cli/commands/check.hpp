// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor check`: grade your own files: the loop to live in.
Action declare_check(Options& options);

} // namespace rigor
