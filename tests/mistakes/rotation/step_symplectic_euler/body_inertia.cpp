// SPDX-License-Identifier: MIT
// I_body⁻¹ is not rotated to world space.
#include "formulas/rotation.hpp"

namespace rigor {

RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step)
{
    if (body.inverse_mass == 0) return state;
    const double h = time_step;
    const Vector3d V = state.velocity + h * body.inverse_mass * wrench.force;
    const Vector3d L = state.angular_momentum + h * wrench.torque;
    const Vector3d w = body.inverse_inertia * L;
    return {state.position + h * V, advance_linear(state.orientation, w, h), V, L};
}

} // namespace rigor
