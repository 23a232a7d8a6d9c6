// SPDX-License-Identifier: MIT
// Bounds of shapes.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"

namespace rigor {

/// Bounds of a shape at a pose. A plane's are infinite.
Bounds bounds_of(const Shape& shape, const Pose& pose);

/// Radius of the ball about the origin of object space that holds the part [m]. A plane's is
/// infinite.
double bounding_radius(const Part& part);

/// Whether a part is a plane.
inline bool is_plane(const Part& part)
{
    return std::holds_alternative<Plane>(part.shape);
}

} // namespace rigor
