// SPDX-License-Identifier: MIT
// Friction bounds the tangential part j_T, not the whole impulse.
#include "formulas/collision.hpp"

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double j_n = j.dot(n);
    return j_n >= 0 && j.norm() <= friction * j_n;
}

} // namespace rigor
