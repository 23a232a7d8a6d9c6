// SPDX-License-Identifier: MIT
// The parts of `bench contact`. Each adds a row for every contestant and a target for our methods.
#pragma once

#include "benchmarks/engines/scenes.hpp"
#include "support/bench/bench.hpp"

namespace rigor {

inline constexpr double contact_step = 1. / 60; // [s], unless a part says otherwise
inline constexpr double contact_end = 10;       // [s]

/// Sticking and slipping of a block, and the creep of a block that should stick.
void measure_stick_or_slip(Bench& bench, const std::vector<Contestant>& all);
void measure_creep(Bench& bench, const std::vector<Contestant>& all);

/// Heights of bounces, and the energy over a hundred bounces.
void measure_bounces(Bench& bench, const std::vector<Contestant>& all);
void measure_elastic_bounces(Bench& bench, const std::vector<Contestant>& all);

/// A heavy cube on a light one, and stacks.
void measure_heavy_on_light(Bench& bench, const std::vector<Contestant>& all);
void measure_stacks(Bench& bench, const std::vector<Contestant>& all);

} // namespace rigor
