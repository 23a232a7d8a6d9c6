// SPDX-License-Identifier: MIT
// The product is q (0, ω), which is for ω in the body's frame.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Quaternion rate = multiply(q, {0, omega / 2});
    return normalize({q.s + time_step * rate.s, q.v + time_step * rate.v});
}

} // namespace rigor
