// SPDX-License-Identifier: MIT
// Bounding the parts along two axes gives a pyramid; the friction cone bounds |j_T|.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    const Vector3d a = n.unitOrthogonal(), b = n.cross(a);
    return j_n >= 0 && std::abs(j_T.dot(a)) <= friction * j_n &&
           std::abs(j_T.dot(b)) <= friction * j_n;
}

} // namespace rigor
