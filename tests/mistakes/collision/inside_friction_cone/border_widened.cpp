// SPDX-License-Identifier: MIT
// The border of the cone is |j_T| = μ jₙ, without a tolerance.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double jn = j.dot(n);
    return jn >= 0 && (j - jn * n).norm() <= friction * jn * (1 + 1e-13);
}

} // namespace rigor
