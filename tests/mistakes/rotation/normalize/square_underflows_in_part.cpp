// SPDX-License-Identifier: MIT
// The sum of squares counts as exact unless it is 0 or infinite; below 1e-308 it loses digits.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double square = q.s * q.s + q.v.squaredNorm();
    if (square > 0 && std::isfinite(square)) {
        const double length = std::sqrt(square);
        return {q.s / length, q.v / length};
    }
    const double largest = std::max(std::abs(q.s), q.v.lpNorm<Eigen::Infinity>());
    if (largest == 0) return {1, Vector3d::Zero()};
    const double s = q.s / largest;
    const Vector3d v = q.v / largest;
    const double length = std::sqrt(s * s + v.squaredNorm());
    return {s / length, v / length};
}

} // namespace rigor
