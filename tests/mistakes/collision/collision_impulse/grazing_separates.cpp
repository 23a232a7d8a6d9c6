// SPDX-License-Identifier: MIT
// A tiny approach counts as none, although K may couple it to a large impulse along the surface.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= -1e-14 * v.norm()) return Vector3d::Zero();
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(j, n, friction)) return j;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
