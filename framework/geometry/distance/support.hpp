// SPDX-License-Identifier: MIT
// Support functions of convex shapes (boxes, cylinders, cones, ellipsoids and convex meshes): the
// point farthest along a direction, and the face, edge or vertex that faces this direction.
#pragma once

#include "geometry/convex/feature.hpp"
#include "geometry/shapes/shape.hpp"

#include <vector>

namespace rigor {

/// Whether the shape is a box, cylinder, cone, ellipsoid or convex mesh, as the functions below
/// require.
bool is_convex_solid(const Shape& shape);

/// The point of a convex shape that is farthest along a direction [m].
Vector3d support(const Shape& shape, const Vector3d& direction);

/// The feature of a convex shape that faces a unit direction: the first of these that exists.
///
///   1. A face, or a line on a round side, whose normal is within 26 degrees of the direction.
///   2. An edge of a box or a mesh that is perpendicular to the direction within 26 degrees.
///   3. The point farthest along the direction.
Feature feature_towards(const Shape& shape, const Vector3d& direction);

/// Appends the outward unit normals of a convex shape's faces (a convex mesh has at most a few
/// dozen). They are candidates for a separating axis.
/// @param towards  for a curved side, only the normal nearest to this direction is appended
void add_face_normals(const Shape& shape, const Vector3d& towards, std::vector<Vector3d>& normals);

} // namespace rigor
