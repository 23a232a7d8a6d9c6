// SPDX-License-Identifier: MIT
// X* is missing: the modes rotate about X, not about the origin.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    S << Matrix3d::Identity(), -cross_matrix(x);
    return S;
}

} // namespace rigor
