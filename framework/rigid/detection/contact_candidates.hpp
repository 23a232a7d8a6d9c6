// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/detection/narrow_phase.hpp"

#include <span>

namespace rigor {

/// The contacts that may close in a step, and data about each body that were computed to find them.
struct ContactCandidates {
    std::vector<Contact> contacts; // empty if no bodies are near enough to meet in this step
    std::vector<Pose> poses;       // one for each body, at the start of the step
    // For each body, whether its contacts were found with its orientation at the end of free flight
    // and its position at the start of the step. Empty if no body rolls over its facets
    // (`turns_over_facets` in contact_candidates.cpp).
    std::vector<char> turned_ahead;
    // One margin for each body [m]; empty if no bodies are near each other. A contact cannot close
    // if its gap after free flight is at least the sum of the margins of its two bodies.
    std::vector<double> margins;
    std::vector<double> radii;  // radius of each body about its center of mass; 0 if static [m]
    std::vector<int> disturbed; // sleeping bodies that have to wake: another body may touch them
};

/// Whether two bodies never collide: both are static, or both have the same group, or a pair law
/// says that they pass through each other.
bool never_collide(const World& world, int i, int j);

/// Finds contact candidates in three stages. The broad phase finds pairs of bodies. Then each body
/// gets its margin: how far it may move in this step, by itself or by impulses. Last, the narrow
/// phase finds the contacts. Changes the world's pair cache and its counters.
///
/// @param flown  the states after free flight
ContactCandidates contact_candidates(World& world, std::span<const RigidState> flown,
                                     double time_step, ThreadPool& pool);

} // namespace rigor
