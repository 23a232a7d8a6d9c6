// SPDX-License-Identifier: MIT
// The figures of assignment A2, about inertia.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> inertia_figures();

} // namespace rigor::figures
