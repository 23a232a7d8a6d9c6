// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor release`: make what students, Gradescope or GitHub get.
Action declare_release(Options& options);

} // namespace rigor
