// SPDX-License-Identifier: MIT
// All columns are scaled by the largest entry of the matrix. So the squares of a column underflow
// if it is much shorter than another one.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const double largest = R.cwiseAbs().maxCoeff();
    const Matrix3d scaled = largest > 0 ? Matrix3d(R / largest) : R;
    const Vector3d a = scaled.col(0).norm() > 0 ? scaled.col(0).normalized() : Vector3d::UnitX();
    Vector3d b = scaled.col(1).norm() > 0 ? scaled.col(1).normalized() : Vector3d::Zero();
    b -= a.dot(b) * a;
    if (b.norm() <= 1e-15) b = a.unitOrthogonal();
    b.normalize();
    b = (b - a.dot(b) * a).normalized();
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
