// SPDX-License-Identifier: MIT
// The figures of assignment A4, about collisions.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> collision_figures();

} // namespace rigor::figures
