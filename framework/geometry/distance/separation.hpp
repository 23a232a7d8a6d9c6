// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"

namespace rigor {

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
/// is deep, an expanding polytope finds a better start (expanding_polytope.hpp).
///
/// @param pose  of shape 1
/// @param reach  farther apart than this, the distance may be any that is larger [m]
Separation separation(const Shape& shape1, const Pose& pose, const Shape& shape2, double reach);

} // namespace rigor
