// SPDX-License-Identifier: MIT
// The factor is 1 instead of 1 + ε: the impulse only stops the approach, without a rebound.
#include "mistakes/collision/jammed_impulse.hpp"

namespace rigor {

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);
    const Vector3d T = v_T.normalized();
    const double nKd = n.dot(K * (n - friction * T));
    if (nKd <= 0) return jammed_impulse(K, v, n, restitution, friction);
    const double j_n = -v_n / nKd;
    return j_n * n - friction * j_n * T;
}

} // namespace rigor
