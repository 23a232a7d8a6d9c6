// SPDX-License-Identifier: MIT
// Clamping the static impulse to the cone leaves a wrong normal velocity instead of -ε vₙ.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0) return Vector3d::Zero();
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(j, n, friction)) return j;
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_n * n + friction * j_n * j_T.normalized();
}

} // namespace rigor
