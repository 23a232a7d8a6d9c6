// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.hpp"

namespace rigor {

Action declare_grade_chunk(Options& options);

} // namespace rigor
