// SPDX-License-Identifier: MIT
// A coupling nᵀ K T that is tiny beside nᵀ K n is taken for rounding. A large coefficient of
// friction makes it count.
#include "mistakes/collision/jammed_impulse.hpp"

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
    if (nKd <= 0) return jammed_impulse(K, v, n, restitution, friction);
    const double j_n = -(1 + restitution) * v_n / nKd;
    return j_n * n - friction * j_n * T;
}

} // namespace rigor
