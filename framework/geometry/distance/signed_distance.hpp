// SPDX-License-Identifier: MIT
// Exact signed distances to all shapes except meshes.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace rigor {

/// The signed distance of a point from a surface, negative inside, and its gradient, the outward
/// unit normal.
struct SurfaceDistance {
    double distance = 0; // [m]
    Vector3d normal = Vector3d::UnitY();
};

// The point p is in the frame of the shape [m]. If several points of a surface are equally near to
// p (p on an axis or in a center), the result is always for the same one of them.
SurfaceDistance signed_distance(const Sphere& sphere, const Vector3d& p);
SurfaceDistance signed_distance(const Capsule& capsule, const Vector3d& p);
SurfaceDistance signed_distance(const Torus& torus, const Vector3d& p);
SurfaceDistance signed_distance(const Box& box, const Vector3d& p);
SurfaceDistance signed_distance(const Cylinder& cylinder, const Vector3d& p);
SurfaceDistance signed_distance(const Cone& cone, const Vector3d& p);
/// The nearest point follows from the root of an equation (Eberly 2013, "Distance from a point to
/// an ellipse, an ellipsoid, or a hyperellipsoid").
SurfaceDistance signed_distance(const Ellipsoid& ellipsoid, const Vector3d& p);
SurfaceDistance signed_distance(const Plane& plane, const Vector3d& p);

/// The signed distance to any shape except a mesh, which has a level set instead.
SurfaceDistance signed_distance(const Shape& shape, const Vector3d& p);

} // namespace rigor
