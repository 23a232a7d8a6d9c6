// SPDX-License-Identifier: MIT
// The cases of `bench skips`: the same work with a skip and without it.
#pragma once

#include "rigid/bodies/world.hpp"
#include "support/bench/bench.hpp"

#include <functional>
#include <string>

namespace rigor {

/// The result of one piece of work.
struct SkipRun {
    double seconds = 0;
    std::vector<double> result; // compared with and without the skip: positions [m] or counts
    double counter = 0;         // the count that shows the effect of the skip
};

struct SkipCase {
    std::string skip, scene;
    std::string counter; // name of what `SkipRun::counter` counts
    std::function<SkipRun()> with, without;
    double bound = 0; // largest allowed difference of the results
};

/// Steps a copy of `world`; the result is the positions of its bodies.
///
/// @param counter  the counter to report, summed over the steps
SkipRun run_steps(const World& world, int steps, std::uint64_t Counters::*counter);

/// The skips that a scene can turn off (`Optimisations` in settings.hpp), each by itself.
std::vector<SkipCase> switchable_skips();
/// The skips that a scene cannot turn off. Each is compared with a scene that means the same, or
/// with the same work done in the direct way.
std::vector<SkipCase> built_in_skips();
/// Level sets that are not needed.
std::vector<SkipCase> mesh_skips();
/// Libraries that a process does not load.
std::vector<SkipCase> process_skips();

} // namespace rigor
