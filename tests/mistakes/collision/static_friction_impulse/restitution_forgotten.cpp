// SPDX-License-Identifier: MIT
// All motion is stopped; the normal velocity after the collision must be -ε vₙ.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d&, double)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return K.inverse() * -v;
}

} // namespace rigor
