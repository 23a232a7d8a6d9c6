// SPDX-License-Identifier: MIT
// A slow rotation is ignored; the result must be smooth as ω → 0.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double speed = omega.norm();
    if (speed < 1e-6) return q;
    const double half = time_step * speed / 2;
    return multiply({std::cos(half), std::sin(half) / speed * omega}, q);
}

} // namespace rigor
