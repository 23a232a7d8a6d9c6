// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where a sphere, a capsule or a torus is nearer to another shape than `reach`.
///
/// Such a shape is a core (a point, a segment, a circle) with a radius around it: it touches where the
/// other shape's distance from the core is least, and along the core wherever that is less than
/// radius and reach. The touch is on its own surface, with the normal through its core. A ball touches
/// a mesh in each place that it looks at squarely; the points of a mesh are held against a capsule or
/// a torus too, so that a peg in a hole touches on all sides.
///
/// @param shape1  a sphere, a capsule or a torus
/// @param shape2  anything but a plane
void find_core_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts);

} // namespace rigor
