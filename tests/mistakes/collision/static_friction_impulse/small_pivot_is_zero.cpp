// SPDX-License-Identifier: MIT
// A direction in which K is below 1e-13 of its largest entry counts as one without an impulse.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();
    Eigen::FullPivLU<Matrix3d> lu(K);
    lu.setThreshold(1e-13);
    return lu.solve(Vector3d(-v - restitution * v.dot(n) * n));
}

} // namespace rigor
