// SPDX-License-Identifier: MIT
// The sign of ε is wrong: the change of velocity is -v - ε vₙ n, so that the bodies separate.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return K.inverse() * (-v + restitution * v.dot(n) * n);
}

} // namespace rigor
