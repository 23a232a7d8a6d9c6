// SPDX-License-Identifier: MIT
// The turn of the last call is used again if the angular velocity is the same.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step)
{
    static Vector3d last = Vector3d::Zero(), half = Vector3d::Zero();
    if (omega != last) half = time_step / 2 * omega;
    last = omega;
    const Quaternion turned = multiply({1, half}, q);
    return normalize(turned);
}

} // namespace rigor
