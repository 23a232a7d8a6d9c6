// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor demo`: render the showcase scenes and grade the sample submissions.
Action declare_demo(Options& options);

} // namespace rigor
