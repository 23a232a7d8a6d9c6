// SPDX-License-Identifier: MIT
// This stops all motion: the normal velocity after the collision is -ε vₙ.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d&, double)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return K.inverse() * -v;
}

} // namespace rigor
