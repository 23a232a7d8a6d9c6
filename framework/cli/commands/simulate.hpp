// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor simulate`: run a scene and store its trajectory.
Action declare_simulate(Options& options);

} // namespace rigor
