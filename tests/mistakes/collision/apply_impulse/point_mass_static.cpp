// SPDX-License-Identifier: MIT
// A body without inverse inertia is left alone, so a point mass is never pushed.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.inverse_mass == 0 || body.inverse_inertia.isZero(0)) return body;
    const Vector3d turn = (x - body.position).cross(j);
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += turn;
    after.angular_velocity += body.inverse_inertia * turn;
    return after;
}

} // namespace rigor
