// SPDX-License-Identifier: MIT
// A small turn is left out. Many small turns are a large one.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    if (time_step * omega.norm() < 1e-8) return R;
    Matrix3d next = R;
    for (int i = 0; i < 3; ++i)
        next.col(i) += time_step * omega.cross(R.col(i));
    return next;
}

} // namespace rigor
