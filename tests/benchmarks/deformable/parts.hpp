// SPDX-License-Identifier: MIT
// The parts of `bench deformable`.
#pragma once

#include "support/bench/bench.hpp"
#include "support/deformables.hpp"

#include <string>

namespace rigor {

/// The processor time of this thread [s].
double thread_seconds();

/// The number of allocations since the program began, and the memory now in use [bytes].
struct Heap {
    std::size_t allocations = 0, bytes = 0;
};
Heap heap();

/// The patch test, perfect plasticity, a bar that hangs under its weight, a bar that vibrates.
///
/// @param folder  where the plot is written; empty for no plot
void measure_accuracy(Bench& bench, const std::string& folder);

/// The time of a step of up to 50 000 tetrahedra by stage, and the time saved by skipping
/// eigenvalues.
void measure_speed(Bench& bench);

/// The change of mass, volume and momenta when a block is split by each fracture method.
void measure_fragments(Bench& bench);

/// Ten simulated minutes of violent deformation.
void measure_abuse(Bench& bench);

} // namespace rigor
