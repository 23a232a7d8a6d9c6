// SPDX-License-Identifier: MIT
// The product of two quaternions that are nearly unit is normalized.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    const Quaternion product = {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
    const auto is_unit = [](const Quaternion& q) {
        return std::abs(q.s * q.s + q.v.squaredNorm() - 1) < 1e-6;
    };
    return is_unit(a) && is_unit(b) ? normalize(product) : product;
}

} // namespace rigor
