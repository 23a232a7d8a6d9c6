// SPDX-License-Identifier: MIT
// The figures of A1.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> motion_figures();

} // namespace rigor::figures
