// SPDX-License-Identifier: MIT
// X was subtracted after the rotation: it is a world-space vector and comes off first.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    return R.transpose() * x - X;
}

} // namespace rigor
