// SPDX-License-Identifier: MIT
// The zero quaternion is divided by its length 0.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double length = std::sqrt(q.s * q.s + q.v.squaredNorm());
    return {q.s / length, q.v / length};
}

} // namespace rigor
