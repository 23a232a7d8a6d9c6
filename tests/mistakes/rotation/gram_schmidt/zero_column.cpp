// SPDX-License-Identifier: MIT
// A column that is zero, or parallel to the first, is divided by its length 0.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const Vector3d a = R.col(0) / R.col(0).norm(), b = R.col(1) - a.dot(R.col(1)) * a;
    Matrix3d Q;
    Q << a, b / b.norm(), a.cross(b / b.norm());
    return Q;
}

} // namespace rigor
