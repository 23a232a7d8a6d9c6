// SPDX-License-Identifier: MIT
// The columns of R are made unit vectors first. In the stages of a Runge-Kutta step R is no
// rotation, and its rate is ω* R all the same.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation.colwise().normalized(),
            inverse_mass * wrench.force, wrench.torque};
}

} // namespace rigor
