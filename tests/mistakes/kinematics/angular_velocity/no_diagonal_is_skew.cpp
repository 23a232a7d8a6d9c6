// SPDX-License-Identifier: MIT
// A matrix whose diagonal is zero is taken for a skew one, and only its lower half is read.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    const Matrix3d A = R_dot * R.transpose();
    if (A.diagonal().isZero(0)) return {A(2, 1), A(0, 2), A(1, 0)};
    return {(A(2, 1) - A(1, 2)) / 2, (A(0, 2) - A(2, 0)) / 2, (A(1, 0) - A(0, 1)) / 2};
}

} // namespace rigor
