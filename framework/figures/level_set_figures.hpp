// SPDX-License-Identifier: MIT
// The figures of assignment A4 that are about level sets.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> level_set_figures();

} // namespace rigor::figures
