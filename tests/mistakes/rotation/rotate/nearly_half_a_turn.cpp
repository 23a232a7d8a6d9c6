// SPDX-License-Identifier: MIT
// A scalar part below 1e-8 is taken as half a turn.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    if (std::abs(q.s) < 1e-8) return 2 * q.v.dot(p) * q.v - p;
    return multiply(multiply(q, {0, p}), conjugate(q)).v;
}

} // namespace rigor
