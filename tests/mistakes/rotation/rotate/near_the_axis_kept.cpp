// SPDX-License-Identifier: MIT
// A vector within a millionth of the direction of the axis is kept.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    if (q.v.cross(p).norm() < 1e-6 * q.v.norm() * p.norm()) return p;
    return multiply(multiply(q, {0, p}), conjugate(q)).v;
}

} // namespace rigor
