// SPDX-License-Identifier: MIT
// An inertia with three equal diagonal entries counts as that of a ball, whatever the others are.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();
    const Matrix3d r_x = cross_matrix(x - X);
    const Matrix3d K = inverse_mass * Matrix3d::Identity();
    const Vector3d moments = I_inverse.diagonal();
    if (moments[0] == moments[1] && moments[1] == moments[2])
        return K + moments[0] * r_x.transpose() * r_x;
    return K + r_x.transpose() * I_inverse * r_x;
}

} // namespace rigor
