// SPDX-License-Identifier: MIT
// The narrow phase: finds where two shapes touch, or are about to touch.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of bodies 1 and 2 that are closer than `reach` [m], sorted by the height of
/// their points, lowest first. The order does not depend on how bodies and parts are numbered.
///
/// @param poses      the poses of all bodies
/// @param counters   receives the counts of built level sets and of their samples
/// @param time_step  the search looks ahead by this time along the bodies' velocities [s]. For a
///                   box and another shape, it prefers a normal along which they are apart now and
///                   will overlap less (box_box.hpp, look_ahead.hpp). For a concave mesh it adds
///                   contacts with the walls that the other shape will reach. With 0, the search
///                   does not look ahead.
/// @throws NonFiniteState if the distance or normal of a level set is not finite
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts, Counters& counters,
                   double time_step = 0);

/// Does the same as the other `find_contacts`, without counters and without looking ahead.
void find_contacts(const World& world, const std::vector<Pose>& poses, int body1, int body2,
                   double reach, std::vector<Contact>& contacts);

} // namespace rigor
