// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor figures`: draw the figures of the handouts.
Action declare_figures(Options& options);

} // namespace rigor
