// SPDX-License-Identifier: MIT
// A point is not turned if its body is more than a trillion times as far away as the point is from
// the center.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    if (X.norm() > 1e12 * p.norm()) return X + p;
    return R * p + X;
}

} // namespace rigor
