// SPDX-License-Identifier: MIT
// A body heavier than 1e9 kg counts as static.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass < 1e-9) return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, inverse_mass * wrench.force,
            wrench.torque};
}

} // namespace rigor
