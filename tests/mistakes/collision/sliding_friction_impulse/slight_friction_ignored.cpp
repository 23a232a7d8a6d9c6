// SPDX-License-Identifier: MIT
// A friction coefficient below 1e-9 is taken as 0, although slight friction is still friction.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (friction < 1e-9) return frictionless_impulse(K, v, n, restitution);
    if (v_T.norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);
    const Vector3d T = v_T.normalized();
    const double nKd = n.dot(K * (n - friction * T));
    if (nKd <= 0) {
        const Vector3d j = static_friction_impulse(K, v, n, restitution);
        const double j_n = j.dot(n);
        const Vector3d j_T = j - j_n * n;
        if (j_n <= 0) return Vector3d::Zero();
        return j_n * n + std::min(1.0, friction * j_n / j_T.norm()) * j_T;
    }
    const double j_n = -(1 + restitution) * v_n / nKd;
    return j_n * n - friction * j_n * T;
}

} // namespace rigor
