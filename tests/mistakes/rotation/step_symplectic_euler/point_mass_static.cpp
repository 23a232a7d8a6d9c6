// SPDX-License-Identifier: MIT
// A body without inverse inertia counts as static, so a point mass does not fall.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0 || body.inverse_inertia.isZero(0)) return state;
    RigidState next = state;
    next.velocity += time_step * body.inverse_mass * wrench.force;
    next.position += time_step * next.velocity;
    next.angular_momentum += time_step * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    const Vector3d w = R * body.inverse_inertia * R.transpose() * next.angular_momentum;
    next.orientation = advance_linear(state.orientation, w, time_step);
    return next;
}

} // namespace rigor
