// SPDX-License-Identifier: MIT
// A body without inverse inertia counts as static, so a point mass is never pushed.
#include "formulas/collision.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (I_inverse.isZero(0)) return Matrix3d::Zero();
    const Vector3d r = x - X;
    Matrix3d K = inverse_mass * Matrix3d::Identity();
    for (int i = 0; i < 3; ++i)
        K.col(i) += (I_inverse * r.cross(Vector3d::Unit(i))).cross(r);
    return inverse_mass == 0 ? Matrix3d::Zero().eval() : K;
}

} // namespace rigor
