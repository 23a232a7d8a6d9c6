// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor bench`: measure run time against error.
Action declare_bench(Options& options);

} // namespace rigor
