// SPDX-License-Identifier: MIT
// Piles of rings, crosses, bowls and gears, which hook into each other.
#pragma once

#include "support/bench/bench.hpp"

namespace rigor {

/// Drops 60, 125, 250 and 500 nonconvex bodies into rooms with the same area per body. Reports the
/// time of a step, its phases, and how the time grows with the number of bodies.
void measure_nonconvex_piles(Bench& bench);

} // namespace rigor
