// SPDX-License-Identifier: MIT
// The sticking impulse of a jam counts as pulling if it hardly pushes.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    if (K.isZero(0)) return Vector3d::Zero();
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);
    const Vector3d T = v_T.normalized(), direction = n - friction * T;
    const double softness = n.dot(K * direction);
    if (softness > 0) return -(1 + restitution) * v_n / softness * direction;
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    const double j_n = j.dot(n);
    if (j_n <= 1e-6 * j.norm()) return Vector3d::Zero();
    const Vector3d j_T = j - j_n * n;
    return j_n * n + std::min(1.0, friction * j_n / j_T.norm()) * j_T;
}

} // namespace rigor
