// SPDX-License-Identifier: MIT
// Sleep: bodies that have come to rest are skipped until something could move them.
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/step/step_result.hpp"

namespace rigor {

/// Puts to sleep every island that stayed in its place, in a world with gravity, if the
/// optimization `sleep` is on. "Stayed in its place" means: for half a second, each body has moved
/// by at most 1e-4 of its radius and rotated by at most 1e-4 radians (less for a body whose radius
/// exceeds the distance of a free fall in this time, see `rest_fraction` in sleep.cpp). The bodies
/// lose their remaining velocity and keep their place. An island on a driven body that moves stays
/// awake.
///
/// @param radii    radius of each body [m]
/// @param has_force  for each body, whether springs or applied forces pull on it; such a body stays
///                 awake, and its island with it
/// @param result   the result of the step: the bodies that fall asleep lose their velocities, and
///                 the memory of the world keeps their contacts
void fall_asleep(World& world, const ContactProblem& problem, const std::vector<double>& radii,
                 const std::vector<bool>& has_force, StepResult& result);

/// Wakes these bodies, which have to be asleep, and all bodies that fell asleep together with them.
/// In the next contact stage, their contacts start from the impulses that they had in the step in
/// which the bodies fell asleep.
void wake(World& world, const std::vector<int>& bodies);

/// Wakes the sleeping bodies on which springs or applied forces pull.
void wake_pulled(World& world, const std::vector<bool>& has_force);

} // namespace rigor
