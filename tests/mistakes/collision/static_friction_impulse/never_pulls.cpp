// SPDX-License-Identifier: MIT
// Bodies that separate get no impulse here, although the formula has no such exception.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0) || v.dot(n) >= 0) return Vector3d::Zero();
    return K.ldlt().solve(-v - restitution * v.dot(n) * n);
}

} // namespace rigor
