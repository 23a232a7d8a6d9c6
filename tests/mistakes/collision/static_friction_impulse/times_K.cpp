// SPDX-License-Identifier: MIT
// The change of velocity is multiplied by K; the impulse is K⁻¹ times it.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return K * (-v - restitution * v.dot(n) * n);
}

} // namespace rigor
