// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

enum class MidpointResult {
    /// The island was solved again.
    solved,
    /// The result of the contact stage stays, in these cases:
    /// 1. There is no `middle_of_step`.
    /// 2. No contact moves along a curve, but one has just closed or has just begun to stick.
    /// 3. With the new result, a contact would close that got no impulse, or the slip of a contact
    ///    would reverse its direction.
    unchanged,
    /// The result of the contact stage stays, although a contact moves along a curve, because a
    /// contact has just closed or has just begun to stick.
    refused,
};

/// Solves the contact stage of an island a second time, with the contacts in the middle of the
/// step. This is done where contacts move along a curve: for a ball that rolls off another one, a
/// disk on its rim, a stick that turns about its foot. It is also done where contacts slide and
/// their slip turns, or their loads change, as below a plank on two rollers (middle_of_step.hpp has
/// the conditions).
///
/// If the island is solved again, its bodies get their velocities at the end of the step, and its
/// contacts get the impulses and normals of the middle of the step. The points of these contacts
/// are moved back to the start of the step, and `gap_correction` is set (case 4 of
/// `ContactConstraint`). The bodies then have to move with the means of their velocities at the
/// start and at the end of the step.
///
/// @param before_forces  the bodies after the collision stage, before the forces
/// @param flown  the states after the flight that the contact stage has used
/// @param poses  poses of all bodies at the start of the step; those of the island's bodies and
///               those of driven bodies that touch them may be changed
/// @return what was done; unless it is `solved`, `problem` has not changed
MidpointResult solve_at_midpoint(const World& world, const std::vector<Body>& before_forces,
                                 const std::vector<RigidState>& flown, const Island& island,
                                 std::vector<Pose>& poses, ContactProblem& problem);

} // namespace rigor
