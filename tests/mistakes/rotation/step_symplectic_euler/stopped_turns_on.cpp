// SPDX-License-Identifier: MIT
// A body that the torque stops turns on with its old angular momentum in this step.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const Vector3d V = state.velocity + time_step * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + time_step * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    const Vector3d turns_with = L.isZero(0) ? state.angular_momentum : L;
    const Vector3d w = R * body.inverse_inertia * R.transpose() * turns_with;
    return {state.position + time_step * V, advance_linear(state.orientation, w, time_step), V, L};
}

} // namespace rigor
