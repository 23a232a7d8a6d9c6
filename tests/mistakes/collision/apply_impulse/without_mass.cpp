// SPDX-License-Identifier: MIT
// The velocity V changes by j/M, not by j.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += j;
    after.angular_momentum += r.cross(j);
    after.angular_velocity += body.inverse_inertia * r.cross(j);
    return after;
}

} // namespace rigor
