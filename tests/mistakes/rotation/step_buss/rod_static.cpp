// SPDX-License-Identifier: MIT
// A body whose inverse inertia cannot be inverted counts as static, so a rod does not fall.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step)
{
    if (body.inverse_mass == 0 || body.inverse_inertia.determinant() == 0) return state;
    const double h = time_step;
    const Vector3d A = body.inverse_mass * wrench.force, L = state.angular_momentum;
    const Matrix3d R = to_matrix(state.orientation);
    const Matrix3d I_inv = R * body.inverse_inertia * R.transpose();
    const Vector3d w = I_inv * L, w_dot = I_inv * (wrench.torque - w.cross(L));
    const Vector3d W = w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w);
    return {state.position + h * state.velocity + h * h / 2 * A,
            advance_exact(state.orientation, W, h), state.velocity + h * A, L + h * wrench.torque};
}

} // namespace rigor
