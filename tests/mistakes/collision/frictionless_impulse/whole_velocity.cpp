// SPDX-License-Identifier: MIT
// Without friction only the normal part of the velocity changes; the tangential part stays.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    if (v_n == 0 || nKn == 0) return Vector3d::Zero();
    return -(1 + restitution) * v / nKn;
}

} // namespace rigor
