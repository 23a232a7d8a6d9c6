// SPDX-License-Identifier: MIT
// An ω that is nearly along the axis of q counts as along it, so the cross product is missing.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    Vector3d across = omega.cross(q.v);
    if (across.norm() < 1e-5 * omega.norm() * q.v.norm()) across.setZero();
    return {-omega.dot(q.v) / 2, (q.s * omega + across) / 2};
}

} // namespace rigor
