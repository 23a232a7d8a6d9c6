// SPDX-License-Identifier: MIT
// The cross product is reversed: it is ω × (x - X), not (x - X) × ω.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const auto velocity = [&](const Body& body) -> Vector3d {
        return (x - body.position).cross(body.angular_velocity) + body.velocity;
    };
    return velocity(body1) - velocity(body2);
}

} // namespace rigor
