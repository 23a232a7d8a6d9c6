// SPDX-License-Identifier: MIT
// A body without angular momentum does not turn in the step, also under a torque.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const Vector3d V = state.velocity + time_step * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + time_step * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    Quaternion q =
        advance_linear(state.orientation, R * body.inverse_inertia * R.transpose() * L, time_step);
    if (state.angular_momentum.isZero(0)) q = state.orientation;
    return {state.position + time_step * V, q, V, L};
}

} // namespace rigor
