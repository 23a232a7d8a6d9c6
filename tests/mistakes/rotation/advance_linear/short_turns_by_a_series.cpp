// SPDX-License-Identifier: MIT
// Short turns are renormalized by the series 1 - |Δt ω/2|²/2, whose error is of fourth order.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Vector3d half = time_step / 2 * omega;
    const Quaternion turned = multiply({1, half}, q);
    if (half.norm() > 1e-3) return normalize(turned);
    const double factor = 1 - half.squaredNorm() / 2;
    return {factor * turned.s, factor * turned.v};
}

} // namespace rigor
