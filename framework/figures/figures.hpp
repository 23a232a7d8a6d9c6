// SPDX-License-Identifier: MIT
// All figures of the handouts.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::vector<Figure> all_figures();

} // namespace rigor::figures
