// SPDX-License-Identifier: MIT
// The scale is the largest of s, x and y; z counts only if these three are 0.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    double scale = std::max({std::abs(q.s), std::abs(q.v.x()), std::abs(q.v.y())});
    if (scale == 0) scale = std::abs(q.v.z());
    if (scale == 0) return Quaternion();
    Quaternion result;
    result.s = q.s / scale;
    result.v = q.v / scale;
    const double length = std::sqrt(result.s * result.s + result.v.squaredNorm());
    result.s /= length;
    result.v /= length;
    return result;
}

} // namespace rigor
