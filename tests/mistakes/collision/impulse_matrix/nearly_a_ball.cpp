// SPDX-License-Identifier: MIT
// An inverse inertia that is the identity but for a trillionth is taken for that of a ball.
#include "formulas/collision.hpp"

namespace rigor {

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero();
    const Vector3d d = x - X;
    Matrix3d K = inverse_mass * Matrix3d::Identity();
    const Matrix3d ball = I_inverse(0, 0) * Matrix3d::Identity();
    if (I_inverse.isApprox(ball)) {
        K += I_inverse(0, 0) * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
        return K;
    }
    Matrix3d c;
    c << 0, -d[2], d[1], //
        d[2], 0, -d[0],  //
        -d[1], d[0], 0;
    K += c.transpose() * I_inverse * c;
    return K;
}

} // namespace rigor
