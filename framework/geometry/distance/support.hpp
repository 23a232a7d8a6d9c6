// SPDX-License-Identifier: MIT
// Convex shapes as what can be felt of them from outside: how far they reach in a direction, and with
// which face, edge or corner. Boxes, cylinders, cones, ellipsoids and meshes without a dent.
#pragma once

#include "geometry/convex/feature.hpp"
#include "geometry/shapes/shape.hpp"

#include <vector>

namespace rigor {

/// Whether the functions below know the shape.
bool is_convex_solid(const Shape& shape);

/// The point of a convex shape that is farthest along a direction (Gilbert, Johnson and Keerthi 1988).
Vector3d support(const Shape& shape, const Vector3d& direction);

/// What a convex shape turns towards a direction: a face or the line of a round side that looks there
/// to 25 degrees, else an edge that is nearly across it, else a point.
Feature feature_towards(const Shape& shape, const Vector3d& direction);

/// Outward unit normals of a convex shape's faces, as directions to try; at most a few dozen.
/// @param towards  what the round side is tried in
void add_face_normals(const Shape& shape, const Vector3d& towards, std::vector<Vector3d>& normals);

} // namespace rigor
