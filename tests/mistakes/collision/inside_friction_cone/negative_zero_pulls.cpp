// SPDX-License-Identifier: MIT
// An impulse of 0 is inside of the cone, also if its product with the normal is -0.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    if (std::signbit(j_n)) return false;
    return (j - j_n * n).norm() <= friction * j_n;
}

} // namespace rigor
