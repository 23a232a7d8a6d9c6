// SPDX-License-Identifier: MIT
// The figures of assignment A8, about tests.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> validation_figures();

} // namespace rigor::figures
