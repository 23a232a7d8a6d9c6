// SPDX-License-Identifier: MIT
// The figures of A4 about level sets.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> level_set_figures();

} // namespace rigor::figures
