// SPDX-License-Identifier: MIT
// A point nearer to the center than a millionth of its distance from the origin gives no turn.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    if (x.isApprox(body.position, 1e-6)) return after;
    const Vector3d torque = (x - body.position).cross(j);
    after.angular_momentum += torque;
    after.angular_velocity += body.inverse_inertia * torque;
    return after;
}

} // namespace rigor
