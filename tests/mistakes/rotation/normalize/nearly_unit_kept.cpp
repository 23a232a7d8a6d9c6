// SPDX-License-Identifier: MIT
// A quaternion whose length is 1 within 1e-9 is returned as it is.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double largest = std::max(std::abs(q.s), q.v.lpNorm<Eigen::Infinity>());
    if (largest == 0) return {1, Vector3d::Zero()};
    const double s = q.s / largest;
    const Vector3d v = q.v / largest;
    const double length = std::sqrt(s * s + v.squaredNorm());
    if (std::abs(length * largest - 1) < 1e-9) return q;
    return {s / length, v / length};
}

} // namespace rigor
