// SPDX-License-Identifier: MIT
// Keeps R⁻¹ from the call before if R is the same up to the 1e-12 of `isApprox`.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    static Matrix3d last = Matrix3d::Zero(), inverse = Matrix3d::Zero();
    if (!R.isApprox(last)) {
        last = R;
        inverse = R.transpose();
    }
    return inverse * (x - X);
}

} // namespace rigor
