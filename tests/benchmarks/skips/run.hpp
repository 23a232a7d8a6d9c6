// SPDX-License-Identifier: MIT
// What `bench skips` measures: one piece of work with a skip and without it, in turns.
#pragma once

#include "rigid/bodies/world.hpp"
#include "support/bench/bench.hpp"

#include <functional>
#include <string>

namespace rigor {

/// What a piece of work came to.
struct SkipRun {
    double seconds = 0;
    std::vector<double> result; // to compare with and without: places of bodies [m], or counts
    double counter = 0;         // what shows the skip
};

struct SkipCase {
    std::string skip, scene;
    std::string counter; // what `SkipRun::counter` counts
    std::function<SkipRun()> with, without;
    double bound = 0; // largest difference of the results
};

/// Steps a copy of `world`; the result is where its bodies are.
///
/// @param counter  of the run, summed over the steps
SkipRun run_steps(const World& world, int steps, std::uint64_t Counters::*counter);

/// The skips of World::skips, each turned off alone.
std::vector<SkipCase> switchable_skips();
/// Those that a scene cannot turn off: against a scene that means the same, or the work done plainly.
std::vector<SkipCase> built_in_skips();
/// Level sets that no scene asked for.
std::vector<SkipCase> mesh_skips();
/// What a process does not load.
std::vector<SkipCase> process_skips();

} // namespace rigor
