// SPDX-License-Identifier: MIT
// μ bounds |j_T|/jₙ, not jₙ/|j_T|.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_n >= 0 && friction * j_T.norm() <= j_n;
}

} // namespace rigor
