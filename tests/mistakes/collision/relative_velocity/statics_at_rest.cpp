// SPDX-License-Identifier: MIT
// Static bodies count as being at rest, although a conveyor belt moves.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    Vector3d v = Vector3d::Zero();
    if (!body1.is_static()) v += body1.velocity + body1.angular_velocity.cross(x - body1.position);
    if (!body2.is_static()) v -= body2.velocity + body2.angular_velocity.cross(x - body2.position);
    return v;
}

} // namespace rigor
