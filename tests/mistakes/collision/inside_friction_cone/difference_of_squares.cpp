// SPDX-License-Identifier: MIT
// |j|² - jₙ² cancels in a narrow cone, so rounding decides.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    return j_n >= 0 && j.squaredNorm() - j_n * j_n <= friction * friction * j_n * j_n;
}

} // namespace rigor
