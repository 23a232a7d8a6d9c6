// SPDX-License-Identifier: MIT
// A relative velocity below a billionth of the speeds counts as rest.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const Vector3d v1 = body1.velocity + body1.angular_velocity.cross(x - body1.position),
                   v2 = body2.velocity + body2.angular_velocity.cross(x - body2.position);
    if ((v1 - v2).norm() < 1e-9 * (v1.norm() + v2.norm())) return Vector3d::Zero();
    return v1 - v2;
}

} // namespace rigor
