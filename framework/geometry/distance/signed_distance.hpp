// SPDX-License-Identifier: MIT
// Exact signed distance to the shapes that have a formula.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace rigor {

/// How far a point is from a surface, negative inside, and the outward unit normal there: the
/// direction in which the distance grows.
struct SurfaceDistance {
    double distance = 0; // [m]
    Vector3d normal = Vector3d::UnitY();
};

// Where several surface points are nearest (on an axis, in a center), one of them is taken: the same
// one each time.
SurfaceDistance signed_distance(const Sphere& sphere, const Vector3d& p);
SurfaceDistance signed_distance(const Capsule& capsule, const Vector3d& p);
SurfaceDistance signed_distance(const Torus& torus, const Vector3d& p);
SurfaceDistance signed_distance(const Box& box, const Vector3d& p);
SurfaceDistance signed_distance(const Cylinder& cylinder, const Vector3d& p);
SurfaceDistance signed_distance(const Cone& cone, const Vector3d& p);
/// By the root of the equation for the nearest point (Eberly 2013, "Distance from a point to an
/// ellipse, an ellipsoid, or a hyperellipsoid").
SurfaceDistance signed_distance(const Ellipsoid& ellipsoid, const Vector3d& p);
SurfaceDistance signed_distance(const Plane& plane, const Vector3d& p);

/// Of any shape but a mesh, whose distance is a level set's.
SurfaceDistance signed_distance(const Shape& shape, const Vector3d& p);

} // namespace rigor
