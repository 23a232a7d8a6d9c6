// SPDX-License-Identifier: MIT
// The result is orthonormalized; this update is meant to show the drift.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    Matrix3d W;
    W << 0, -omega.z(), omega.y(), //
        omega.z(), 0, -omega.x(),  //
        -omega.y(), omega.x(), 0;
    return gram_schmidt(R + time_step * W * R);
}

} // namespace rigor
