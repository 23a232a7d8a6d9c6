// SPDX-License-Identifier: MIT
// A static body without a velocity V counts as being at rest, although a turntable spins.
#include "formulas/collision.hpp"

namespace rigor {

namespace {

Vector3d velocity_of(const Body& body, const Vector3d& x)
{
    if (body.is_static() && body.velocity.isZero(0)) return Vector3d::Zero();
    return body.velocity + body.angular_velocity.cross(x - body.position);
}

} // namespace

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    return velocity_of(body1, x) - velocity_of(body2, x);
}

} // namespace rigor
