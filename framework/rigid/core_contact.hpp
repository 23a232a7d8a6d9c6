// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/narrow_phase.hpp"

namespace rigor {

/// Appends where a sphere, a capsule or a torus is nearer to another shape than `reach`.
///
/// Such a shape is a core (a point, a segment, a circle) with a radius around it: it touches where the
/// other shape's distance from the core is least, and along the core wherever that is less than
/// radius and reach. The touch is on its own surface, with the normal through its core.
///
/// @param shape1  a sphere, a capsule or a torus
/// @param shape2  anything but a plane
void touch_core(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                double reach, Counters& counters, std::vector<Touch>& touches);

} // namespace rigor
