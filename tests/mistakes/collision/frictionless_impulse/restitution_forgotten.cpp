// SPDX-License-Identifier: MIT
// The factor is 1 instead of 1 + ε: the impulse only stops the approach, without a rebound.
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
