// SPDX-License-Identifier: MIT
// Stage 4 of a step: the forces change the velocities.
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Gives the bodies of an island their velocities after the forces. In a moving frame
/// (contact/driven_bodies.hpp), the fictitious force is added.
/// @param before_forces  the bodies before the forces
/// @param flown  the states after the forces alone
void apply_forces(const World& world, const Island& island, const std::vector<Body>& before_forces,
                  const std::vector<RigidState>& flown, ContactProblem& problem);

} // namespace rigor
