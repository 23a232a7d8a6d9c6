// SPDX-License-Identifier: MIT
// Bounding boxes and bounding radii of shapes.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"

namespace rigor {

/// Bounds of a shape at a pose. They are the smallest possible ones, except for a mesh, and
/// infinite for a plane.
Bounds bounds_of(const Shape& shape, const Pose& pose);

/// Radius of a ball about the origin of the body's frame that contains the part, however it is
/// turned [m]. That of a plane is infinite.
double bounding_radius(const Part& part);

/// Whether a part is a plane.
inline bool is_plane(const Part& part)
{
    return std::holds_alternative<Plane>(part.shape);
}

} // namespace rigor
