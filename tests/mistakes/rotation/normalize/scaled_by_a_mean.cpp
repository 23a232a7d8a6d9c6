// SPDX-License-Identifier: MIT
// Before it is squared, q is divided by the geometric mean of its largest and its smallest
// component, from whose product a square may underflow or overflow.
#include "formulas/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const Eigen::Vector4d all(q.s, q.v.x(), q.v.y(), q.v.z());
    double largest = 0, smallest = INFINITY;
    for (const double x : all.cwiseAbs())
        if (x > 0) {
            largest = std::max(largest, x);
            smallest = std::min(smallest, x);
        }
    if (largest == 0) return {1, Vector3d::Zero()};
    const Eigen::Vector4d scaled = all / std::sqrt(largest * smallest);
    const Eigen::Vector4d unit = scaled / scaled.norm();
    return {unit[0], unit.tail<3>()};
}

} // namespace rigor
