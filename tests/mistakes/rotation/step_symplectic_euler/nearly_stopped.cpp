// SPDX-License-Identifier: MIT
// An angular momentum that falls below 1e-11 of itself in the step becomes 0.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const Vector3d V = state.velocity + time_step * body.inverse_mass * wrench.force;
    Vector3d L = state.angular_momentum + time_step * wrench.torque;
    if (L.norm() < 1e-11 * state.angular_momentum.norm()) L.setZero();
    const Matrix3d R = to_matrix(state.orientation);
    return {
        state.position + time_step * V,
        advance_linear(state.orientation, R * body.inverse_inertia * R.transpose() * L, time_step),
        V, L};
}

} // namespace rigor
