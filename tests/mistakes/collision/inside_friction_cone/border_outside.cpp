// SPDX-License-Identifier: MIT
// The border belongs to the cone: the test is |j_T| ≤ μ jₙ, not |j_T| < μ jₙ.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_n >= 0 && j_T.norm() < friction * j_n;
}

} // namespace rigor
