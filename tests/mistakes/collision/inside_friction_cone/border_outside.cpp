// SPDX-License-Identifier: MIT
// The border of the cone belongs to it: |j_T| ≤ μ jₙ, not less.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_n >= 0 && j_T.norm() < friction * j_n;
}

} // namespace rigor
