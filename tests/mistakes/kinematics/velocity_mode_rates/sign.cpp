// SPDX-License-Identifier: MIT
// The velocities are subtracted the wrong way around.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d S_dot;
    S_dot << Matrix3d::Zero(), cross_matrix(v - V);
    return S_dot;
}

} // namespace rigor
