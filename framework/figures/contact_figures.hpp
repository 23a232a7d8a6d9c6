// SPDX-License-Identifier: MIT
// The figures of A5.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> contact_figures();

} // namespace rigor::figures
