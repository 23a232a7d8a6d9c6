// SPDX-License-Identifier: MIT
// The point is rotated but not translated: + X is missing.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p)
{
    return R * p;
}

} // namespace rigor
