// SPDX-License-Identifier: MIT
// The sign of ε: afterwards the bodies must separate, and the change of velocity is -v - ε vₙ n.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return K.inverse() * (-v + restitution * v.dot(n) * n);
}

} // namespace rigor
