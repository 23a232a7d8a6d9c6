// SPDX-License-Identifier: MIT
// What is nearly a rotation is returned as it is.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    if ((R.transpose() * R - Matrix3d::Identity()).norm() < 1e-10 && R.determinant() > 0) return R;
    const Vector3d a = R.col(0).stableNormalized(), raw = R.col(1).stableNormalized();
    Vector3d b = raw - a.dot(raw) * a;
    if (a.isZero(0) || b.norm() < 1e-14) return Matrix3d::Identity();
    b.normalize();
    b = (b - a.dot(b) * a).normalized();
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
