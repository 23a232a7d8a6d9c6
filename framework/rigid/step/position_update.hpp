// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// Positions, after the stages of contact.
///
/// A body that only bounced flies on with its velocity after the collision, with gravity in its
/// integrator. A body that contacts hold moves with its velocity at the end of the step, which does not
/// take it into what holds it. There is one exception: if the integrator is of higher order and the
/// contacts hold along the same normals during the whole step, the body moves with the mean of its
/// velocities at start and end, which is exact for a constant acceleration.
///
/// @param after_collisions  the bodies after the collision stage, before the forces
/// @param displacements     of all bodies, or none
/// @param states            after free flight; those of bodies that got an impulse are replaced
void update_positions(World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
                      const std::vector<Body>& after_collisions,
                      const std::vector<Displacement>& displacements,
                      std::vector<RigidState>& states);

} // namespace rigor
