// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Solves islands again by `solve_at_midpoint` where this is possible, and finds the islands whose
/// bodies move with the mean of their velocities at the start and the end of the step, which gives
/// positions of second-order accuracy. These are the islands that were solved again, and the
/// islands whose contacts act along the same normals during the whole step. There are no such
/// islands if the world's integrator is only of first order under forces.
///
/// @param before_forces  the bodies after the collision stage, before the forces
/// @param flown             the states after the flight that the contact stage has used
/// @param poses             the poses of all bodies at the start of the step
/// @param problem           the problem after the contact stage; `solve_at_midpoint` changes it
/// @return for each island, whether its bodies move with this mean
std::vector<char> solve_again_at_midpoint(const World& world,
                                          const std::vector<Body>& before_forces,
                                          const std::vector<RigidState>& flown,
                                          std::vector<Pose> poses, ContactProblem& problem);

} // namespace rigor
