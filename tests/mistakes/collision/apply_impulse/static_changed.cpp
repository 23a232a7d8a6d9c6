// SPDX-License-Identifier: MIT
// A static body must stay unchanged, and that includes its angular momentum.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += r.cross(j);
    after.angular_velocity += body.inverse_inertia * r.cross(j);
    return after;
}

} // namespace rigor
