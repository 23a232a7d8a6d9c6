// SPDX-License-Identifier: MIT
// The rows are orthonormalized instead of the columns.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    Matrix3d Q;
    const Vector3d a = R.row(0).transpose().normalized();
    const Vector3d b = (R.row(1).transpose() - a.dot(R.row(1)) * a).normalized();
    Q << a.transpose(), b.transpose(), a.cross(b).transpose();
    return Q;
}

} // namespace rigor
