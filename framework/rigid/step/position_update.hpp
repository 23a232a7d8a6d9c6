// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// Computes the poses and velocities at the end of the step, after the collision stage, the contact
/// stage and the position correction.
///
/// A body that only bounced and is not `pulled` flies on with its velocity after the collision
/// stage, and its integrator adds gravity. Any other body that got an impulse moves with its
/// velocity at the end of the step. The contact stage has computed this velocity such that the body
/// does not move into the bodies that hold it. The bodies of some islands move with the mean of
/// their velocities at the start and the end of the step instead (mean_velocity.hpp), which is
/// exact for a constant acceleration. The displacements are added to the resulting poses.
///
/// @param world             only its counters change
/// @param pulled            for each body, whether springs, applied forces or drag act on it
/// @param before_forces  the bodies after the collision stage, before the forces
/// @param by_mean           for each island, whether its bodies move with their mean velocities
/// @param displacements     the position corrections, one for each body, or an empty list
/// @param flown_again       for each body, whether `states` has its flight after the collisions
///                          (bounced_flight.hpp); or an empty list. Such a body keeps this state
///                          if it got no impulse in the contact stage.
/// @param states            the states after the flight that the contact stage has used; changed
///                          for bodies that got an impulse or a displacement
void update_positions(World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
                      const std::vector<Body>& before_forces, const std::vector<char>& by_mean,
                      const std::vector<Displacement>& displacements,
                      const std::vector<bool>& flown_again, std::vector<RigidState>& states);

} // namespace rigor
