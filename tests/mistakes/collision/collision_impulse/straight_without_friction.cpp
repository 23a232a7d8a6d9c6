// SPDX-License-Identifier: MIT
// A contact that does not slide may still need friction to stick, since K couples the directions.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    const double v_n = v.dot(n);
    if (v_n >= 0) return Vector3d::Zero();
    if ((v - v_n * n).isZero(0)) return frictionless_impulse(K, v, n, restitution);
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(j, n, friction)) return j;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
