// SPDX-License-Identifier: MIT
// The quaternion contains the full angle instead of half of it, so it turns twice as far.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.norm();
    if (speed == 0) return q;
    const double angle = time_step * speed;
    return multiply({std::cos(angle), std::sin(angle) / speed * omega}, q);
}

} // namespace rigor
