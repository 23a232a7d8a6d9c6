// SPDX-License-Identifier: MIT
// For a body that is round about its x axis, ω × L is left out of the angular acceleration.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Vector3d &L = state.angular_momentum, a = body.inverse_mass * wrench.force;
    const Matrix3d R = to_matrix(state.orientation),
                   I_inv = R * body.inverse_inertia * R.transpose();
    const Vector3d w = I_inv * L;
    const Matrix3d& I = body.inverse_inertia;
    const bool is_round = I.isDiagonal(0) && I(1, 1) == I(2, 2);
    Vector3d w_dot = I_inv * (wrench.torque - w.cross(L));
    if (is_round) w_dot = I_inv * wrench.torque;
    const Vector3d W = w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w);
    return {state.position + h * state.velocity + h * h / 2 * a,
            advance_exact(state.orientation, W, h), state.velocity + h * a, L + h * wrench.torque};
}

} // namespace rigor
