// SPDX-License-Identifier: MIT
// The figures of assignment A7, about fracture.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> fracture_figures();

} // namespace rigor::figures
