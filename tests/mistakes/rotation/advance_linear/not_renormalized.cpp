// SPDX-License-Identifier: MIT
// The result is not normalized again.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Quaternion rate = quaternion_rate(q, omega);
    return {q.s + time_step * rate.s, q.v + time_step * rate.v};
}

} // namespace rigor
