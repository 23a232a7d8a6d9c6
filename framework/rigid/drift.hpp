// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"
#include "rigid/healing.hpp"

namespace rigor {

/// Positions, after the stages of contact. A body that only bounced flies on from there, with gravity in its
/// integrator. A body that is held drifts: with its velocity at the end of the step, which does not take it into
/// what holds it; or, by an integrator of higher order and held along the same normals all the step long, with
/// the mean of start and end, which is exact for a constant acceleration.
///
/// @param bounced        the bodies after collisions, as the forces find them
/// @param displacements  of all bodies, or none
/// @param states         after free flight; those of bodies that got an impulse are replaced
void move(const World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
          const std::vector<Body>& bounced, const std::vector<Displacement>& displacements,
          std::vector<RigidState>& states, Counters& counters);

} // namespace rigor
