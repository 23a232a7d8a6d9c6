// SPDX-License-Identifier: MIT
// Without restitution, an impulse that adds energy is shortened until it adds none. The formula
// returns it whole.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0) return Vector3d::Zero();
    const Vector3d held = static_friction_impulse(K, v, n, restitution);
    const Vector3d j = inside_friction_cone(held, n, friction)
                           ? held
                           : sliding_friction_impulse(K, v, n, restitution, friction);
    const double work = -2 * j.dot(v), needed = j.dot(K * j);
    if (restitution > 0 || needed <= work || needed <= 0) return j;
    return std::max(work / needed, 0.0) * j;
}

} // namespace rigor
