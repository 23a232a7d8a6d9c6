// SPDX-License-Identifier: MIT
// A negative restitution counts as zero, although it stops only a part of the approach.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    const double e = std::max(restitution, 0.0);
    if (v.dot(n) >= 0) return Vector3d::Zero();
    const Vector3d j = static_friction_impulse(K, v, n, e);
    if (inside_friction_cone(j, n, friction)) return j;
    return sliding_friction_impulse(K, v, n, e, friction);
}

} // namespace rigor
