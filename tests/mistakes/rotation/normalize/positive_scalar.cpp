// SPDX-License-Identifier: MIT
// The sign of q is changed to make the scalar part positive; it must stay.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion normalize(const Quaternion& q)
{
    const double length = (q.s < 0 ? -1 : 1) * std::sqrt(q.s * q.s + q.v.squaredNorm());
    if (length == 0) return {};
    return {q.s / length, q.v / length};
}

} // namespace rigor
