// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/step/midpoint/held_contacts.hpp"

#include <map>
#include <optional>

namespace rigor {

/// An island in the middle of the step. It has the contacts that hold their bodies there
/// (held_contacts.hpp); the contacts of a pair follow each other. Its bodies, by their indices in
/// the world, are those of the island, and the driven bodies that they touch, if these change their
/// place. They have their poses in the middle of the step, but their velocities and angular momenta
/// at the start.
struct MiddleOfStep {
    std::vector<HeldContact> contacts;
    std::map<int, Body> bodies;
    // Whether a contact moves along a curve. Otherwise, contacts with driven bodies that turn slide
    // along a body, and their loads change, as below a plank on two rollers.
    bool has_curve = false;
    // Whether all contacts slide and stay closed, and the slip of one of them turns. Then friction
    // acts against the mean of the slip at the start and at the end.
    bool slip_turns = false;
};

/// Computes the middle of the step for an island whose contacts move along a curve. Contacts count
/// if they got an impulse, or if a driven body that turns closes them within the step. These
/// islands are left out: large ones (more than `few_bodies` bodies or 32 contacts), those that
/// touch no static body, those that have or touch a mesh, and those that touch a static or driven
/// body whose velocity changes in the step, as seen from the frame of the island (see
/// contact/driven_bodies.hpp). With the contact methods `one_at_a_time` and `shock_propagation`,
/// all islands are left out.
///
/// Also computes it for an island whose contacts all slide, stay closed, and move along straight
/// lines, in two cases: if the slip of a contact turns, as where a block is kicked across a slope,
/// or if the island slides over driven bodies that turn and a contact moves along a body of the
/// island, because the loads on the contacts change then.
///
/// @param before_forces  the bodies after the collision stage, before the forces
/// @param problem  after the contact stage
/// @param poses    poses of all bodies at the start of the step; those of the island's bodies and
///                 those of driven bodies that touch them may be changed
/// @return nothing if the island is left out, if no contact moves in one of these ways, or if a
///         contact is not found again in the middle of the step
std::optional<MiddleOfStep> middle_of_step(const World& world, const ContactProblem& problem,
                                           const Island& island,
                                           const std::vector<Body>& before_forces,
                                           std::vector<Pose>& poses);

/// The part of v along the surface: v - (v·n) n
inline Vector3d slip(const Vector3d& v, const Vector3d& n)
{
    return v - v.dot(n) * n;
}

/// Whether a contact slides: its friction is at the limit, up to rounding.
bool slides(const ContactConstraint& contact);

/// v₁ - v₂ at the point of a contact [m/s].
Vector3d velocity_at(const Contact& contact, const Body& body1, const Body& body2);

} // namespace rigor
