// SPDX-License-Identifier: MIT
// A torque about an axis about which the body does not turn changes nothing, not even L.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.inverse_mass == 0) return body;
    const Vector3d torque = (x - body.position).cross(j);
    const Vector3d turn = body.inverse_inertia * torque;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_velocity += turn;
    if (body.inverse_inertia.isZero(0) || !turn.isZero(0)) after.angular_momentum += torque;
    return after;
}

} // namespace rigor
