// SPDX-License-Identifier: MIT
// p = Rᵀ (x - X): the transpose is missing.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x)
{
    return R * (x - X);
}

} // namespace rigor
