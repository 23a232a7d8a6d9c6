// SPDX-License-Identifier: MIT
// The part along the first column is removed only once, so rounding errors of it may stay.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const Vector3d a = R.col(0).isZero(0) ? Vector3d::UnitX() : R.col(0).normalized();
    Vector3d b = R.col(1) - a.dot(R.col(1)) * a;
    if (b.norm() <= 1e-14 * R.col(1).norm()) b = a.unitOrthogonal();
    b.normalize();
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
