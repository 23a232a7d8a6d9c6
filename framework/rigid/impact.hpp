// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

#include <optional>

namespace rigor {

/// Lets two bodies that did nothing in this step but bounce off each other do so where they meet:
/// they fly to the moment of impact, bounce there, and fly on for the rest of the step. So a bounce
/// keeps the order of free flight, and without loss (ε = 1) its energy.
///
/// The moment is found by the gaps along the flight itself (a secant method from the prediction).
///
/// @param pair    the only one of its island that bounced; nothing is held there
/// @param states  of all bodies: those of the two are set
/// @return  the contacts with their impulses, none where the bodies do not meet in this step after all;
///          empty if it is no such bounce (they would meet again within the step, or touched before it),
///          and then the states are as they were
std::optional<std::vector<ContactRecord>> bounce_at_impact(const World& world,
                                                           const ContactProblem& problem,
                                                           const ContactPair& pair,
                                                           std::vector<RigidState>& states);

} // namespace rigor
