// SPDX-License-Identifier: MIT
// An axis with a tiny inverse moment loses its products too, which may be far larger.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    Matrix3d A = I_body_inverse;
    for (int i = 0; i < 3; ++i)
        if (A(i, i) <= 1e-15 * I_body_inverse.diagonal().maxCoeff()) {
            A.row(i).setZero();
            A.col(i).setZero();
        }
    return R * A * R.transpose();
}

} // namespace rigor
