// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

/// The command `rigor render`: draw a scene or a stored trajectory as frames.
Action declare_render(Options& options);

} // namespace rigor
