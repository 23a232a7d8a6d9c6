// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor hint`: give a hint for a task, and the next one each time.
Action declare_hint(Options& options);

} // namespace rigor
