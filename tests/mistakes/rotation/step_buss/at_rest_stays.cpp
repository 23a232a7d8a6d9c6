// SPDX-License-Identifier: MIT
// A body without angular momentum does not turn in the step, also under a torque.
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
    const Vector3d w = I_inv * L, w_dot = I_inv * (wrench.torque - w.cross(L)),
                   W = w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w);
    Quaternion q = advance_exact(state.orientation, W, h);
    if (L.isZero(0)) q = state.orientation;
    return {state.position + h * state.velocity + h * h / 2 * a, q, state.velocity + h * a,
            L + h * wrench.torque};
}

} // namespace rigor
