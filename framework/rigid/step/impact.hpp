// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// For two bodies that only bounced off each other in this step, moves the bounce to the time of
/// impact: they fly until they meet, bounce there, and fly on for the rest of the step. Such a
/// bounce has the order of accuracy of free flight and conserves the energy if ε = 1.
///
/// The secant method finds the time of impact from the gap at several times of the flight, starting
/// from a prediction. The bounce stays as it was if the bodies would meet again within the step, if
/// they touched at the start of the step, or if springs, applied forces, drag or a position
/// correction move one of them.
///
/// @param pulled         for each body, whether springs, applied forces or drag act on it
/// @param displacements  the position corrections, one for each body, or an empty list
/// @param states  the states of all bodies; the states of pairs whose bounce is moved are replaced
/// @return the contacts of these bounces with their impulses; in `problem`, the impulses of these
///         contacts become zero
std::vector<ContactRecord> bounce_at_impacts(const World& world, ContactProblem& problem,
                                             const std::vector<bool>& pulled,
                                             const std::vector<Displacement>& displacements,
                                             std::vector<RigidState>& states);

} // namespace rigor
