// SPDX-License-Identifier: MIT
// A point nearer to X than a millionth of its distance from the origin counts as the center.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();
    const Matrix3d r_x = cross_matrix(x - X);
    const Matrix3d K = inverse_mass * Matrix3d::Identity();
    if (x.isApprox(X, 1e-6)) return K;
    return K + r_x.transpose() * I_inverse * r_x;
}

} // namespace rigor
