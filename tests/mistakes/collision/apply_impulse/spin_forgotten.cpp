// SPDX-License-Identifier: MIT
// ω must change as well: the next contact of this body reads it.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += r.cross(j);
    return after;
}

} // namespace rigor
