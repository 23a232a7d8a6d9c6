// SPDX-License-Identifier: MIT
// The relative velocity is v₁ - v₂, not v₂ - v₁.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const auto velocity = [&](const Body& body) -> Vector3d {
        return body.angular_velocity.cross(x - body.position) + body.velocity;
    };
    return velocity(body2) - velocity(body1);
}

} // namespace rigor
