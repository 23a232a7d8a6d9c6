// SPDX-License-Identifier: MIT
// A static body is stopped, although a conveyor belt keeps its motion.
#include "formulas/collision.hpp"

namespace rigor {

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    Body after = body;
    if (body.is_static()) {
        after.velocity.setZero();
        return after;
    }
    const Vector3d turn = (x - body.position).cross(j);
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += turn;
    after.angular_velocity += body.inverse_inertia * turn;
    return after;
}

} // namespace rigor
