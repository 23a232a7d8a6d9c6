// SPDX-License-Identifier: MIT
// The product is q (0, ω), which is for ω in the body's frame.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega)
{
    return multiply(q, {0, omega / 2});
}

} // namespace rigor
