// SPDX-License-Identifier: MIT
// Rings, crosses, bowls and gears that hook into each other.
#pragma once

#include "support/bench/bench.hpp"

namespace rigor {

/// Drops 60, 125, 250 and 500 nonconvex bodies into rooms of as many square metres a body, and tells
/// what a step costs, where it goes, and how that grows with their number.
void measure_nonconvex_piles(Bench& bench);

} // namespace rigor
