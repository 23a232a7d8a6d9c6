// SPDX-License-Identifier: MIT
// The arccosine of a number near 1 loses half of the digits of the angle.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    const double length = q.v.norm();
    if (length == 0) return p;
    const double angle = 2 * std::acos(std::clamp(q.s, -1.0, 1.0));
    const Vector3d e = q.v / length;
    return std::cos(angle) * p + (1 - std::cos(angle)) * e.dot(p) * e +
           std::sin(angle) * e.cross(p);
}

} // namespace rigor
