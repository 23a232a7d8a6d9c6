// SPDX-License-Identifier: MIT
// A diagonal with one zero is taken for that of a rod, whose other two moments are equal.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    const Vector3d along = I_body_inverse.diagonal();
    for (int i = 0; i < 3; ++i) {
        const double a = along[(i + 1) % 3], b = along[(i + 2) % 3];
        if (!I_body_inverse.isDiagonal(0) || along[i] != 0 || a == 0 || b == 0) continue;
        const Vector3d d = R.col(i);
        return (a + b) / 2 * (Matrix3d::Identity() - d * d.transpose());
    }
    return R * I_body_inverse * R.transpose();
}

} // namespace rigor
