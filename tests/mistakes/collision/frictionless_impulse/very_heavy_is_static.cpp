// SPDX-License-Identifier: MIT
// A threshold with a unit, however small, makes some body static that can move.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double nKn = n.dot(K * n);
    if (nKn < 1e-20) return Vector3d::Zero();
    return -(1 + restitution) * v.dot(n) / nKn * n;
}

} // namespace rigor
