// SPDX-License-Identifier: MIT
// The narrow phase: finds where two shapes touch, or are about to touch.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of two shapes that are closer than `reach`.
///
/// A sphere has one contact with another shape, but it may have several with a torus or a mesh.
/// Each normal passes through the center of the sphere, so an impulse without friction has no
/// torque about this center.
///
/// The methods for other shapes are in plane_contact.hpp, core_contact.hpp (capsules and tori),
/// box_box.hpp, convex_contact.hpp (all other pairs of convex shapes) and mesh_contact.hpp (a mesh
/// that is not convex). Two planes never touch.
///
/// Two capsules are sampled like any capsule (core_contact.hpp), although their distance has a
/// closed form. To use the closed form, write the contact search in a module
/// `shapes/capsule_capsule`, and let `find_ordered` call it for two capsules before it calls
/// `find_core_contacts`. Two parallel capsules need a contact at each end of the part where they
/// lie side by side; core_contact_test.cpp has such cases. These tests expect the contact points on
/// the surface of the first capsule.
void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, double reach, std::vector<Contact>& contacts);

/// Appends the contacts of bodies 1 and 2 that are closer than `reach` [m], sorted by the height of
/// their points, lowest first. The order does not depend on how bodies and parts are numbered.
///
/// @param poses      the poses of all bodies
/// @param counters   receives the counts of built level sets and of their samples
/// @param time_step  the search looks ahead by this time along the bodies' velocities [s]. For two
///                   boxes, or a sphere and a box, it prefers a normal along which they are apart
///                   now and will overlap less (box_box.hpp). For a concave mesh it adds contacts
///                   with the walls that the other shape will reach. With 0, the search does not
///                   look ahead.
/// @throws NonFiniteState if the distance or normal of a level set is not finite
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters,
                   double time_step = 0);

/// Does the same as the other `find_contacts`, without counters and without looking ahead.
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts);

} // namespace rigor
