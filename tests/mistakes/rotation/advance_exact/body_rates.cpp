// SPDX-License-Identifier: MIT
// The new rotation multiplies q from the right, which is for ω in the body's frame.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.norm();
    if (speed == 0) return q;
    const double half = time_step * speed / 2;
    return multiply(q, {std::cos(half), std::sin(half) / speed * omega});
}

} // namespace rigor
