// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor list`: show assignments, tasks, points and scenes.
Action declare_list(Options& options);

} // namespace rigor
