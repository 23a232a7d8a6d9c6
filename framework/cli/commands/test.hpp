// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor test`: check this tree in minutes, or all that CI checks.
Action declare_test(Options& options);

} // namespace rigor
