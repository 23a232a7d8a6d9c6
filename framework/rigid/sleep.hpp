// SPDX-License-Identifier: MIT
// Bodies that have come to rest are left alone until something could move them.
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// Puts to sleep every island that stayed where it was: with gravity, bodies in contact of which none
/// moved by more than 1e-4 of its radius, nor turned by more than 1e-4 radians, for half a
/// second. They lose the speed they have left, and stay in that place.
///
/// @param states  of all bodies after the step
/// @param pulled  bodies that springs or applied forces pull at stay awake, and their islands with them
/// @param records  of the step: those of a sleeping island stay as they are
void fall_asleep(World& world, const ContactProblem& problem, const std::vector<double>& radii,
                 const std::vector<bool>& pulled, std::vector<RigidState>& states,
                 const std::vector<ContactRecord>& records);

/// Wakes these bodies, and all that fell asleep with them.
void wake(World& world, const std::vector<int>& bodies);

} // namespace rigor
