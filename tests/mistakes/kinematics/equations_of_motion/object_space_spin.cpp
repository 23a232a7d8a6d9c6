// SPDX-License-Identifier: MIT
// Ṙ = ω* R with ω in world space; here it is R ω*.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, state.rotation * cross_matrix(w), wrench.force * inverse_mass,
            wrench.torque};
}

} // namespace rigor
