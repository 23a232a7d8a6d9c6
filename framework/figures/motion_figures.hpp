// SPDX-License-Identifier: MIT
// The figures of assignment A1, about rigid motion.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> motion_figures();

} // namespace rigor::figures
