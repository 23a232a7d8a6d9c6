// SPDX-License-Identifier: MIT
// Depth of the overlap of two shapes, measured independently of the engine's narrow phase.
#pragma once

#include "geometry/shapes/pose.hpp"

namespace rigor::testing {

/// Signed distance of two boxes along the axis of their largest separation, one of the 15 axes of
/// Gottschalk, Lin and Manocha (1996). For boxes that overlap it is minus the shortest distance
/// that parts them [m].
double box_separation(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2);

/// Depth of the overlap of two shapes, 0 if they do not overlap. For spheres, boxes and planes it
/// is the shortest distance that parts them [m].
///
/// @throws std::invalid_argument for another shape
double overlap_depth(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                     const Pose& pose2);

} // namespace rigor::testing
