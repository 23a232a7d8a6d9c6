// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// Computes the positions after the contact stages.
///
/// A body that only bounced and is not `pulled` flies on with its velocity after the collision, and
/// its integrator adds gravity. Any other body that got an impulse moves with its velocity at the
/// end of the step: the contacts have made this velocity such that the body does not move into
/// those that hold it. There is one exception: if the integrator is of higher order and the
/// contacts act along the same normals during the whole step, the body moves with the mean of its
/// velocities at the start and the end of the step, which is exact for a constant acceleration.
///
/// @param pulled            for each body, whether springs, applied forces or drag act on it
/// @param after_collisions  the bodies after the collision stage, before the forces
/// @param displacements     one for each body, or an empty list
/// @param states            the states after free flight; replaced for bodies that got an impulse
void update_positions(World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
                      const std::vector<Body>& after_collisions,
                      const std::vector<Displacement>& displacements,
                      std::vector<RigidState>& states);

} // namespace rigor
