// SPDX-License-Identifier: MIT
// The inverse of the largest component overflows if it is one of the smallest doubles.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double largest = std::max(std::abs(q.s), q.v.cwiseAbs().maxCoeff());
    if (largest == 0) return {};
    const double factor = 1 / largest, s = q.s * factor;
    const Vector3d v = q.v * factor;
    const double length = std::sqrt(s * s + v.dot(v));
    return {s / length, v / length};
}

} // namespace rigor
