// SPDX-License-Identifier: MIT
// The change of omega is I^-1 (new L - old L), which loses its digits where L is large.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += (x - body.position).cross(j);
    after.angular_velocity +=
        body.inverse_inertia * (after.angular_momentum - body.angular_momentum);
    return after;
}

} // namespace rigor
