// SPDX-License-Identifier: MIT
// Projectors n nᵀ and δ - n nᵀ as matrices, and the inverse of K instead of a decomposition.
// The normal and the tangential part of a velocity are products with these projectors.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double k = n.transpose() * K * n;
    if (k == 0) return Vector3d::Zero();
    return (-(1 + restitution) / k) * (n * n.transpose()) * v;
}

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();
    const Matrix3d N = n * n.transpose();
    return K.inverse() * (-(Matrix3d::Identity() + restitution * N) * v);
}

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
    return n.dot(j) >= 0 && (P * j).norm() <= friction * n.dot(j);
}

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (n.dot(v) >= 0) return Vector3d::Zero();
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    return inside_friction_cone(j, n, friction)
               ? j
               : sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
