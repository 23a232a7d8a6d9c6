// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor book`: make one page of all handouts.
Action declare_book(Options& options);

} // namespace rigor
