// SPDX-License-Identifier: MIT
// The sign is wrong: vₙ is negative when bodies approach, and the impulse must push.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    if (nKn == 0) return Vector3d::Zero();
    return (1 + restitution) * v_n / nKn * n;
}

} // namespace rigor
