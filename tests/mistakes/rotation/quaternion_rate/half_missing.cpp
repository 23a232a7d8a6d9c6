// SPDX-License-Identifier: MIT
// The factor ½ is missing: a quaternion contains half the angle.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    return multiply({0, omega}, q);
}

} // namespace rigor
