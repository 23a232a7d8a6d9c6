// SPDX-License-Identifier: MIT
// Convex shapes as what can be felt of them from outside: how far they reach in a direction, and with
// which face, edge or corner. Boxes, cylinders, cones, ellipsoids and meshes without a dent.
#pragma once

#include "geometry/bounds.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rigor {

/// Whether the functions below know the shape.
bool is_convex_solid(const Shape& shape);

/// The point of a convex shape that is farthest along a direction (Gilbert, Johnson and Keerthi 1988).
Vector3d support(const Shape& shape, const Vector3d& direction);

/// A convex polygon, a segment or a point of a surface. A circle is eight points of it.
struct Feature {
    static constexpr int most = 16;
    std::array<Vector3d, most> points;
    int count = 0;

    void add(const Vector3d& p)
    {
        if (count < most) points[count++] = p;
    }
};

/// What a convex shape turns towards a direction: a face or the line of a round side that looks there
/// to 25 degrees, else an edge that is nearly across it, else a point.
Feature feature_towards(const Shape& shape, const Vector3d& direction);

/// Outward unit normals of a convex shape's faces, as directions to try; at most a few dozen.
/// @param towards  what the round side is tried in
void add_face_normals(const Shape& shape, const Vector3d& towards, std::vector<Vector3d>& normals);

/// Where one convex shape is nearest to another, or goes deepest into it.
struct Separation {
    double distance = 0;                 // negative: how far they overlap [m]
    Vector3d normal = Vector3d::UnitY(); // unit, from shape 2 to shape 1
    Vector3d point1, point2;             // of each surface [m]
};

/// Distance of two convex shapes, exact to rounding where they are apart; where they overlap, the
/// shortest way that parts them. All in the frame of shape 2.
///
/// Apart: the point of the shapes' difference nearest to the origin (Gilbert, Johnson and Keerthi 1988,
/// "A fast procedure for computing the distance between complex objects"). Overlapping: shape 1 is
/// pushed out along the best of some directions until it is just apart, and the normal found there
/// is the next direction, as long as that parts them sooner. Where this does not settle, or the overlap
/// is deep, an expanding polytope finds a better start (polytope.hpp).
///
/// @param pose  of shape 1
/// @param reach  farther apart than this, the distance may be any that is larger [m]
Separation separation(const Shape& shape1, const Pose& pose, const Shape& shape2, double reach);

} // namespace rigor
