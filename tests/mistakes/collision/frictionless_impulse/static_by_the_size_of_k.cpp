// SPDX-License-Identifier: MIT
// Both bodies count as static if nᵀ K n is small beside K, as it is if the lever lies along n.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double softness = n.dot(K * n);
    if (softness <= 1e-12 * K.norm()) return Vector3d::Zero();
    return -(1 + restitution) * v.dot(n) / softness * n;
}

} // namespace rigor
