// SPDX-License-Identifier: MIT
// The angular momentum is used as the angular velocity; ω = I(t)⁻¹ L.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Vector3d w = state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, wrench.force * inverse_mass,
            wrench.torque};
}

} // namespace rigor
