// SPDX-License-Identifier: MIT
// The sum of the components overflows if they are the largest doubles.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double sum = std::abs(q.s) + q.v.cwiseAbs().sum();
    if (sum == 0) return {};
    const double s = q.s / sum;
    const Vector3d v = q.v / sum;
    const double length = std::sqrt(s * s + v.dot(v));
    return {s / length, v / length};
}

} // namespace rigor
