// SPDX-License-Identifier: MIT
// How deep two bodies are inside each other, measured apart from the engine's own narrow phase.
#pragma once

#include "geometry/shapes/pose.hpp"

namespace rigor::testing {

/// Signed distance of two boxes along the axis that separates them most: of boxes that overlap, minus
/// the shortest way that parts them (the 15 axes of Gottschalk, Lin and Manocha 1996) [m].
double box_separation(const Box& box1, const Pose& pose1, const Box& box2, const Pose& pose2);

/// Depth of the overlap of two shapes, 0 if they do not overlap: for spheres, boxes and planes the
/// shortest way that parts them [m].
///
/// @throws std::invalid_argument for another shape
double overlap_depth(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                     const Pose& pose2);

} // namespace rigor::testing
