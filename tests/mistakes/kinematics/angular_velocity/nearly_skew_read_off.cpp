// SPDX-License-Identifier: MIT
// Only the lower half of a nearly skew matrix is read, with half of its small symmetric part.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    const Matrix3d A = R_dot * R.transpose();
    if ((A + A.transpose()).norm() < 1e-6 * A.norm()) return {A(2, 1), A(0, 2), A(1, 0)};
    return {(A(2, 1) - A(1, 2)) / 2, (A(0, 2) - A(2, 0)) / 2, (A(1, 0) - A(0, 1)) / 2};
}

} // namespace rigor
