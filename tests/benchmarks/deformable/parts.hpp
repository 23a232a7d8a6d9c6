// SPDX-License-Identifier: MIT
// The parts of the benchmark of deformable solids.
#pragma once

#include "support/bench/bench.hpp"
#include "support/deformables.hpp"

#include <string>

namespace rigor {

/// What this thread has used of a processor [s].
double thread_seconds();

/// Allocations since the program began, and what of them is in use now [bytes].
struct Heap {
    std::size_t allocations = 0, bytes = 0;
};
Heap heap();

/// One stress in a mesh of any shape, a bar that hangs, a bar that rings.
/// @param folder  for the plot; empty: none
void measure_accuracy(Bench& bench, const std::string& folder);

/// 50 000 tetrahedra, stage by stage; eigenvalues skipped and not.
void measure_speed(Bench& bench);

/// A block that comes apart in each way: what becomes of its mass, volume and momenta.
void measure_fragments(Bench& bench);

/// Ten simulated minutes of ill-treatment.
void measure_abuse(Bench& bench);

} // namespace rigor
