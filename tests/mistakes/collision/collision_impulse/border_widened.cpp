// SPDX-License-Identifier: MIT
// An impulse just outside of the cone must slide, without any tolerance; here it sticks.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0) return Vector3d::Zero();
    const Vector3d stick = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(stick, n, friction * (1 + 1e-10))) return stick;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
