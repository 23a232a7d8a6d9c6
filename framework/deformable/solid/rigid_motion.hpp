// SPDX-License-Identifier: MIT
// The motion (V, ω) of a rigid body as one vector of six numbers, and the Jacobian of its points.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

using Vector6d = Eigen::Matrix<double, 6, 1>;

inline Vector6d stacked(const Vector3d& a, const Vector3d& b)
{
    Vector6d both;
    both << a, b;
    return both;
}

/// The Jacobian J of the point at r from the center of a body: the velocity of the point is
/// V + ω × r = J (V, ω).
inline Matrix36d point_jacobian(const Vector3d& r)
{
    Matrix36d J;
    J << Matrix3d::Identity(), Matrix3d{{0, r.z(), -r.y()}, {-r.z(), 0, r.x()}, {r.y(), -r.x(), 0}};
    return J;
}

} // namespace rigor
