// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of a sphere, a capsule or a torus with another shape that is closer than
/// `reach`.
///
/// Such a shape is a core (a point, a segment, a circle) with a radius around it. It touches where
/// the other shape's distance from the core is least. Where the gap is below `reach`, a capsule
/// also touches at samples along its segment, and a torus at four or eight points spread evenly
/// around its circle. A contact lies on the shape's own surface (for a ball on a torus: in the
/// middle of the gap), and its normal passes through the core. A ball touches a mesh at each local
/// minimum of the distance. For a capsule or a torus against a mesh, the points of the mesh are
/// tested too, so that a peg in a hole has contacts on all sides.
///
/// @param shape1  a sphere, a capsule or a torus
/// @param shape2  anything but a plane
void find_core_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts);

} // namespace rigor
