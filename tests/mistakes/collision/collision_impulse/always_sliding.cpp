// SPDX-License-Identifier: MIT
// Inside the friction cone the contact sticks, so the static impulse must be tried first.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0) return Vector3d::Zero();
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

} // namespace rigor
