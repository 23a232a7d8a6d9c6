// SPDX-License-Identifier: MIT
// Restitution acts on the normal velocity only; the tangential velocity becomes zero.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d&,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return -(1 + restitution) * (K.inverse() * v);
}

} // namespace rigor
