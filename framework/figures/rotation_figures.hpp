// SPDX-License-Identifier: MIT
// The figures of assignment A3, about rotation.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> rotation_figures();

} // namespace rigor::figures
