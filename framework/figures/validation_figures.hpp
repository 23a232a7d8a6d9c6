// SPDX-License-Identifier: MIT
// The figures of A8.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> validation_figures();

} // namespace rigor::figures
