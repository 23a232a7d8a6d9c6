// SPDX-License-Identifier: MIT
// The absolute value of a small angle loses the sign of Δt, so a short step back turns forward.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.stableNorm();
    if (speed == 0) return q;
    double half = time_step * speed / 2;
    if (std::abs(half) < 1e-2) half = std::abs(half);
    return multiply({std::cos(half), std::sin(half) * omega.stableNormalized()}, q);
}

} // namespace rigor
