// SPDX-License-Identifier: MIT
// A sliding velocity below 1e-6 m/s counts as none; the contract compares it with |v|.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= 1e-6) return frictionless_impulse(K, v, n, restitution);
    const Vector3d T = v_T.normalized();
    const double nKd = n.dot(K * (n - friction * T));
    if (nKd > 0) return -(1 + restitution) * v_n / nKd * (n - friction * T);
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    const double j_n = j.dot(n);
    if (j_n <= 0) return Vector3d::Zero();
    const Vector3d j_T = j - j_n * n;
    if (j_T.norm() <= friction * j_n) return j;
    return j_n * n + friction * j_n * j_T.normalized();
}

} // namespace rigor
