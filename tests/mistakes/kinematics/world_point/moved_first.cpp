// SPDX-License-Identifier: MIT
// The point is translated before it is rotated: R (p + X) instead of R p + X.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    return R * (p + X);
}

} // namespace rigor
