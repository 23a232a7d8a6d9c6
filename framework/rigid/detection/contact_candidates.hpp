// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/detection/narrow_phase.hpp"

#include <span>

namespace rigor {

/// The contacts that may matter in a step, and what is known of each body on the way to them.
struct ContactCandidates {
    std::vector<Contact> contacts; // empty if no bodies are near enough to meet in this step
    std::vector<Pose> poses;       // of each body, at the start of the step
    std::vector<double> margins;   // of each body: contacts farther apart cannot matter [m]
    std::vector<double> radii;     // of each body, about its center of mass; 0 if static [m]
    std::vector<int> disturbed;    // sleeping bodies that another may touch: they have to wake first
};

/// The broad phase, the margins that impulses may need, and the narrow phase.
///
/// @param flown  the states after free flight
ContactCandidates contact_candidates(World& world, std::span<const RigidState> flown,
                                     double time_step, ThreadPool& pool);

} // namespace rigor
