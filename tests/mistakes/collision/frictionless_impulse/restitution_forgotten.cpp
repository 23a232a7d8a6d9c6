// SPDX-License-Identifier: MIT
// This only stops the approach: bouncing back takes 1 + ε times as much.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n, double)
{
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    if (nKn == 0) return Vector3d::Zero();
    return -v_n / nKn * n;
}

} // namespace rigor
