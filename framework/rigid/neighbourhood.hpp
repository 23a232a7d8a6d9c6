// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/narrow_phase.hpp"
#include "rigid/team.hpp"
#include "rigid/world.hpp"

#include <span>

namespace rigor {

/// What may meet in a step.
struct Neighbourhood {
    std::vector<Contact> contacts; // none if no bodies are near enough to meet in this step
    std::vector<Pose> poses;       // of each body, as the step begins
    std::vector<double> margins;   // of each body: how far apart it may stay and still matter [m]
    std::vector<double> radii;     // of each body, about its center of mass; 0 if static [m]
    std::vector<int> disturbed; // sleeping bodies that another may touch: they have to wake first
};

/// @param flown   the states after free flight
/// @param memory  the world's, see near_pairs
Neighbourhood neighbourhood(const World& world, std::span<const RigidState> flown, double time_step,
                            PairMemory& memory, Counters& counters, Team& team);

} // namespace rigor
