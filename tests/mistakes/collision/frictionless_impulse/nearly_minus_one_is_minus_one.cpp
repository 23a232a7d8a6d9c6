// SPDX-License-Identifier: MIT
// A restitution next to -1 counts as -1, but ε = -1 + 1/n takes one nth of the velocity.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double nKn = n.dot(K * n);
    if (nKn == 0 || 1 + restitution < 1e-9) return Vector3d::Zero();
    return -(1 + restitution) * v.dot(n) / nKn * n;
}

} // namespace rigor
