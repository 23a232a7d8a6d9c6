// SPDX-License-Identifier: MIT
// In world space L̇ = τ; the term ω × L belongs to a rotating frame.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Vector3d& L = state.angular_momentum;
    const Vector3d w = I_inverse * L;
    return {state.velocity, cross_matrix(w) * state.rotation, wrench.force * inverse_mass,
            wrench.torque - w.cross(L)};
}

} // namespace rigor
