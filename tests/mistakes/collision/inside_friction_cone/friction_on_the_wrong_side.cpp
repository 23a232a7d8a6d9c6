// SPDX-License-Identifier: MIT
// The friction coefficient is on the wrong side: the test is |j_T| ≤ μ jₙ, not μ |j_T| ≤ jₙ.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_n >= 0 && friction * j_T.norm() <= j_n;
}

} // namespace rigor
