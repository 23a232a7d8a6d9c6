// SPDX-License-Identifier: MIT
// The lever arm is x - X, measured from the center of mass, not x.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += r.cross(j);
    after.angular_velocity += body.inverse_inertia * r.cross(j);
    return after;
}

} // namespace rigor
