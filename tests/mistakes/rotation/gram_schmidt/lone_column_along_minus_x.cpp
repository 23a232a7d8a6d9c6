// SPDX-License-Identifier: MIT
// A column along -x is completed with the help of x, to which it is parallel.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const Vector3d a = R.col(0).isZero(0) ? Vector3d::UnitX() : R.col(0).stableNormalized();
    Vector3d b = R.col(1).isZero(0) ? Vector3d::Zero() : R.col(1).stableNormalized();
    b -= a.dot(b) * a;
    if (b.norm() <= 1e-15)
        b = (a == Vector3d::UnitX() ? Vector3d::UnitY() : Vector3d::UnitX()).cross(a);
    b.normalize();
    b = (b - a.dot(b) * a).normalized();
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
