// SPDX-License-Identifier: MIT
// Without friction it is not asked whether the bodies approach, so the impulse may pull.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (friction == 0) return frictionless_impulse(K, v, n, restitution);
    if (v.dot(n) >= 0) return Vector3d::Zero();
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(j, n, friction)) return j;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
