// SPDX-License-Identifier: MIT
// A coupling nᵀ K T that is tiny beside nᵀ K n is taken for rounding. A large coefficient of
// friction makes it count.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);
    const Vector3d T = v_T.normalized();
    const double nKn = n.dot(K * n), coupling = n.dot(K * T);
    const double nKd = nKn - (std::abs(coupling) < 1e-12 * nKn ? 0 : friction * coupling);
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
