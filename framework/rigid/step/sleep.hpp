// SPDX-License-Identifier: MIT
// Sleep: bodies that have come to rest are skipped until something could move them.
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Puts to sleep every island that stayed in its place, in a world with gravity: for half a second,
/// each body has moved by at most 1e-4 of its radius and rotated by at most 1e-4 radians (less for
/// a body that is larger than a free fall in this time, see `rest_fraction` in sleep.cpp). The
/// bodies lose their remaining velocity and keep their place. An island on a driven body that moves
/// stays awake.
///
/// @param radii    radius of each body [m]
/// @param forced   for each body, whether springs or applied forces pull on it; such a body stays
///                 awake, and its island with it
/// @param states   the states of all bodies after the step
/// @param records  the contacts of the step; those of islands that fall asleep are kept in the
///                 memory of the world
void fall_asleep(World& world, const ContactProblem& problem, const std::vector<double>& radii,
                 const std::vector<bool>& forced, std::vector<RigidState>& states,
                 const std::vector<ContactRecord>& records);

/// Wakes these bodies, which have to be asleep, and all bodies that fell asleep together with them.
void wake(World& world, const std::vector<int>& bodies);

/// Wakes the sleeping bodies on which springs or applied forces pull.
void wake_pulled(World& world, const std::vector<bool>& forced);

} // namespace rigor
