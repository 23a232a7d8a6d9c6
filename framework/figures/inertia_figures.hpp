// SPDX-License-Identifier: MIT
// The figures of A2.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> inertia_figures();

} // namespace rigor::figures
