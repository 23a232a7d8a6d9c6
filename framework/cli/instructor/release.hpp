// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

Action declare_release(Options& options);

} // namespace rigor
