// SPDX-License-Identifier: MIT
// A direction a million times as stiff as another counts as static.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double nKn = n.dot(K * n);
    if (nKn <= 1e-6 * K.norm()) return Vector3d::Zero();
    return -(1 + restitution) * v.dot(n) / nKn * n;
}

} // namespace rigor
