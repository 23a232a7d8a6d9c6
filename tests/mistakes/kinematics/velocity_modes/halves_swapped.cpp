// SPDX-License-Identifier: MIT
// The halves of S are swapped: the coefficients are (V, ω) in this order.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x)
{
    Matrix36d S;
    S << cross_matrix(X - x), Matrix3d::Identity();
    return S;
}

} // namespace rigor
