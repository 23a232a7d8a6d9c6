// SPDX-License-Identifier: MIT
// The factor ½ is missing, so that the body turns by nearly twice the angle.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Quaternion rate = quaternion_rate(q, omega);
    return normalize({q.s + 2 * time_step * rate.s, q.v + 2 * time_step * rate.v});
}

} // namespace rigor
