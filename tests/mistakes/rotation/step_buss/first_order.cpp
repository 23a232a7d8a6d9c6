// SPDX-License-Identifier: MIT
// The terms of Ω after ω are missing, which makes the method first order.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Matrix3d R = to_matrix(state.orientation);
    const Matrix3d I_inv = R * body.inverse_inertia * R.transpose();
    const Vector3d L = state.angular_momentum;
    const Vector3d w = I_inv * L;
    const Vector3d W = w;
    return {state.position + h * state.velocity + h * h / 2 * body.inverse_mass * wrench.force,
            advance_exact(state.orientation, W, h),
            state.velocity + h * body.inverse_mass * wrench.force,
            state.angular_momentum + h * wrench.torque};
}

} // namespace rigor
