// SPDX-License-Identifier: MIT
// The update is R + Δt R ω*; ω is in world space, so ω* must be on the left of R.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    Matrix3d W;
    W << 0, -omega.z(), omega.y(), //
        omega.z(), 0, -omega.x(),  //
        -omega.y(), omega.x(), 0;
    return R + time_step * R * W;
}

} // namespace rigor
