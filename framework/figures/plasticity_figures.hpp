// SPDX-License-Identifier: MIT
// The figures of assignment A6, about plasticity.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> plasticity_figures();

} // namespace rigor::figures
