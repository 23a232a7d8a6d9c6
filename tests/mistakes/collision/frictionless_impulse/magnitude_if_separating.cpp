// SPDX-License-Identifier: MIT
// For bodies that separate, the magnitude of a negative restitution is taken.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double v_n = v.dot(n), K_n = n.dot(K * n);
    if (K_n == 0) return Vector3d::Zero();
    const double e = v_n > 0 ? std::abs(restitution) : restitution;
    return -(1 + e) * v_n / K_n * n;
}

} // namespace rigor
