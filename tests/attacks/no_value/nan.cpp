// SPDX-License-Identifier: MIT
// A formula that returns a NaN.
#include "formulas/kinematics.hpp"

#include <limits>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    Matrix3d w_star = Matrix3d::Zero();
    w_star(0, 1) = std::numeric_limits<double>::quiet_NaN();
    return w_star;
}

} // namespace rigor
