// SPDX-License-Identifier: MIT
// The figures of assignment A2, about inertia, and one figure of A3.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> inertia_figures();

} // namespace rigor::figures
