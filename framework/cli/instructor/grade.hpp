// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor grade`: grade a class: folders and archives.
Action declare_grade(Options& options);

} // namespace rigor
