// SPDX-License-Identifier: MIT
// Where two shapes touch, or are about to.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// Appends where shape 1 and shape 2 are closer than `reach`.
///
/// A sphere has one touch, on its surface (between two spheres, in the middle of the gap), with the
/// normal through its center: so an impulse without friction never spins it. Against a plane, see
/// plane_contact.hpp; a capsule and a torus, core_contact.hpp; two boxes, box_box.hpp; two other
/// convex shapes, convex_contact.hpp; a mesh with a dent, mesh_contact.hpp. Two planes never touch.
void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                  double reach, std::vector<Contact>& contacts);

/// Appends the contacts of bodies 1 and 2, from the lowest up: an order that does not depend on how bodies
/// and parts are numbered.
///
/// @param poses     of all bodies
/// @param counters  level sets built and samples taken of them are added to it
/// @param time_step  with the velocities of that long, spheres and boxes look for a normal along which
///                   they are apart now and will not meet (box_box.hpp); 0: the poses alone count [s]
/// @throws NonFiniteState if a level set's distance or normal is no number
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters,
                   double time_step = 0);

/// The same, uncounted.
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts);

} // namespace rigor
