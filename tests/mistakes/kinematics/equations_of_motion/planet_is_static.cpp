// SPDX-License-Identifier: MIT
// An inverse mass that is tiny counts as 0, so that a planet does not move.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass < 1e-20) return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, inverse_mass * wrench.force,
            wrench.torque};
}

} // namespace rigor
