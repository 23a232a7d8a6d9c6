// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// Lets two bodies that did nothing in this step but bounce off each other do so where they meet: they
/// fly to the moment of impact, bounce there, and fly on for the rest of the step. So a bounce keeps the
/// order of free flight, and without loss (ε = 1) its energy.
///
/// The moment of impact is found by the gaps along the flight itself, by the secant method from a
/// prediction. A bounce is left as it was if the bodies would meet again within the step, touched
/// before it, or if springs, applied forces or a position correction move one of them.
///
/// @param states  of all bodies; those of such pairs are replaced
/// @return the contacts of those bounces with their impulses; they are taken out of the problem
std::vector<ContactRecord> bounce_at_impacts(const World& world, ContactProblem& problem,
                                             const std::vector<bool>& pulled,
                                             const std::vector<Displacement>& displacements,
                                             std::vector<RigidState>& states);

} // namespace rigor
