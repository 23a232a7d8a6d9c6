// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor compare`: find the first step where two implementations differ.
Action declare_compare(Options& options);

} // namespace rigor
