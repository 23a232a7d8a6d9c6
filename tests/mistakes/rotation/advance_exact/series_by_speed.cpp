// SPDX-License-Identifier: MIT
// The series for short turns is used for slow bodies, also in long steps.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.stableNorm(), half = time_step * speed / 2, x2 = half * half;
    const double sinc = speed < 1e-4 ? 1 - x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42))
                                     : (half == 0 ? 1 : std::sin(half) / half);
    return multiply({std::cos(half), time_step / 2 * sinc * omega}, q);
}

} // namespace rigor
