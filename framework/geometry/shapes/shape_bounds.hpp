// SPDX-License-Identifier: MIT
// Bounding boxes and bounding radii of shapes.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"

namespace rigor {

/// Bounding box of a shape at a pose. It is the smallest possible box, except that for a mesh it
/// may be larger, and for a plane it is infinite.
Bounds bounds_of(const Shape& shape, const Pose& pose);

/// Radius of a ball around the origin of the body's frame that contains the part, however the body
/// is turned [m]. For a plane the radius is infinite.
double bounding_radius(const Part& part);

/// Whether a part is a plane.
inline bool is_plane(const Part& part)
{
    return std::holds_alternative<Plane>(part.shape);
}

} // namespace rigor
