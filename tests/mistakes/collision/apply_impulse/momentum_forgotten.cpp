// SPDX-License-Identifier: MIT
// L must change as well: the next step computes ω from L and would undo the collision.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_velocity += body.inverse_inertia * r.cross(j);
    return after;
}

} // namespace rigor
