// SPDX-License-Identifier: MIT
// The cross product is reversed: the change of L is (x - X) × j, not j × (x - X).
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Vector3d r = x - body.position;
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += j.cross(r);
    after.angular_velocity += body.inverse_inertia * j.cross(r);
    return after;
}

} // namespace rigor
