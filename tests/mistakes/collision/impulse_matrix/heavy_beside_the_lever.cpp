// SPDX-License-Identifier: MIT
// The mass is ignored if the lever softens the contact a million times as much.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();
    const Matrix3d r_x = cross_matrix(x - X);
    const Matrix3d turning = r_x.transpose() * I_inverse * r_x;
    if (inverse_mass < 1e-6 * turning.norm()) return turning;
    return inverse_mass * Matrix3d::Identity() + turning;
}

} // namespace rigor
