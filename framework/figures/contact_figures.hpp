// SPDX-License-Identifier: MIT
// The figures of assignment A5, about contact.
#pragma once

#include "figures/figure.hpp"

namespace rigor::figures {

std::span<const Figure> contact_figures();

} // namespace rigor::figures
