// SPDX-License-Identifier: MIT
// A static body moves; it must stay unchanged.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    const double h = time_step;
    const Vector3d V = state.velocity + h * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + h * wrench.torque;
    const Matrix3d R = to_matrix(state.orientation);
    const Vector3d w = R * body.inverse_inertia * R.transpose() * L;
    return {state.position + h * V, advance_linear(state.orientation, w, h), V, L};
}

} // namespace rigor
