// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor grade-chunk`: grade a part of a class. Slurm starts it.
Action declare_grade_chunk(Options& options);

} // namespace rigor
