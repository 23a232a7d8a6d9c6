// SPDX-License-Identifier: MIT
// Rᵀ Ṙ gives ω along the axes of the body; in world space it is Ṙ Rᵀ.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    const Matrix3d A = R.transpose() * R_dot;
    const Matrix3d w_x = (A - A.transpose()) / 2;
    return {w_x(2, 1), w_x(0, 2), w_x(1, 0)};
}

} // namespace rigor
