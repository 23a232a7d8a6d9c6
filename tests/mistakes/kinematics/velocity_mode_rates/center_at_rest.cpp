// SPDX-License-Identifier: MIT
// The center of the body moves too; only x is differentiated here.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_mode_rates(const Vector3d&, const Vector3d& v)
{
    Matrix36d S_dot;
    S_dot << Matrix3d::Zero(), cross_matrix(-v);
    return S_dot;
}

} // namespace rigor
