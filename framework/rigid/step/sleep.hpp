// SPDX-License-Identifier: MIT
// Bodies that have come to rest are left alone until something could move them.
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Puts to sleep every island that stayed where it was: with gravity, bodies in contact of which none
/// moved by more than 1e-4 of its radius, nor turned by more than 1e-4 radians, for half a second. They
/// lose the speed they have left, and stay in that place.
///
/// @param radii    of all bodies [m]
/// @param pulled   for each body, whether springs or applied forces pull at it: such a body stays awake,
///                 and its island with it
/// @param states   of all bodies after the step
/// @param records  the contacts of the step; those of a sleeping island stay as they are
void fall_asleep(World& world, const ContactProblem& problem, const std::vector<double>& radii,
                 const std::vector<bool>& pulled, std::vector<RigidState>& states,
                 const std::vector<ContactRecord>& records);

/// Wakes these bodies, and all that fell asleep with them.
void wake(World& world, const std::vector<int>& bodies);

/// Wakes the sleeping bodies that springs or applied forces pull at.
void wake_pulled(World& world, const std::vector<bool>& pulled);

} // namespace rigor
