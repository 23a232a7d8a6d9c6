// SPDX-License-Identifier: MIT
// The columns are made orthogonal but not normalized.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d gram_schmidt(const Matrix3d& R)
{
    const Vector3d a = R.col(0), b = R.col(1) - a.dot(R.col(1)) / a.squaredNorm() * a;
    Matrix3d Q;
    Q << a, b, a.cross(b);
    return Q;
}

} // namespace rigor
