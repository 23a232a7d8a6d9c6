// SPDX-License-Identifier: MIT
// A negative restitution, as topic `contact` uses it, is taken as 0.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();
    return K.inverse() * (-v - std::max(restitution, 0.0) * v.dot(n) * n);
}

} // namespace rigor
