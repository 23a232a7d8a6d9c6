// SPDX-License-Identifier: MIT
// Distance and penetration depth of convex shapes.
#pragma once

#include "geometry/shapes/pose.hpp"

namespace rigor {

/// The place where two convex shapes are nearest to each other, or where they overlap.
struct Separation {
    double distance = 0;                 // if negative, minus the penetration depth [m]
    Vector3d normal = Vector3d::UnitY(); // unit, from shape 2 to shape 1
    // nearest points, or points of contact, on the surfaces of shapes 1 and 2 [m]
    Vector3d point1 = Vector3d::Zero(), point2 = Vector3d::Zero();
};

/// The distance of two convex shapes, exact to rounding, or their penetration depth: the length of
/// the shortest translation that separates them. `is_convex_solid` (support.hpp) has to be true for
/// both shapes, so spheres and capsules are excluded. All vectors are in the frame of shape 2.
///
/// If the shapes are apart, the point of the Minkowski difference nearest to the origin is found
/// (Gilbert, Johnson and Keerthi 1988, "A fast procedure for computing the distance between complex
/// objects"). If they overlap or nearly touch, shape 1 is pushed out along the best of several
/// candidate directions until the shapes are just apart. The normal between the shapes is then the
/// next direction, as long as the depth along it is smaller than the one before. If this does not
/// converge, or the overlap is deep, the search begins a second time, with a direction from an
/// expanding polytope (expanding_polytope.hpp); the result is the smaller of the two depths.
///
/// @param pose   pose of shape 1
/// @param reach  if the shapes are farther apart than this, the result may be any lower bound of
///               their distance that is at least `reach` [m]
Separation separation(const Shape& shape1, const Pose& pose, const Shape& shape2, double reach);

} // namespace rigor
