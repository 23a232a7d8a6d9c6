// SPDX-License-Identifier: MIT
// A second column within 1e-12 of the direction of the first counts as depending on it.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const Vector3d a = R.col(0).isZero(0) ? Vector3d::UnitX() : R.col(0).normalized();
    Vector3d b = R.col(1).isZero(0) ? Vector3d::Zero() : R.col(1).normalized();
    b -= a.dot(b) * a;
    if (b.norm() < 1e-12) b = a.unitOrthogonal();
    b.normalize();
    b = (b - a.dot(b) * a).normalized();
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
