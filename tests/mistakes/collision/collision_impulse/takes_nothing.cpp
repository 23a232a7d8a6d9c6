// SPDX-License-Identifier: MIT
// With a restitution of -1 there is no impulse; but friction may still act where K couples it.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0 || restitution <= -1) return Vector3d::Zero();
    const Vector3d sticking = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(sticking, n, friction)) return sticking;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
