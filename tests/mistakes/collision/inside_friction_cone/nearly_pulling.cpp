// SPDX-License-Identifier: MIT
// A pull of less than a billionth of the impulse counts as a push.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    return j_n >= -1e-9 * j.norm() && (j - j_n * n).norm() <= friction * std::abs(j_n);
}

} // namespace rigor
