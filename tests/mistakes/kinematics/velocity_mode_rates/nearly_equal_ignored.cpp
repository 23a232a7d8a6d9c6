// SPDX-License-Identifier: MIT
// The rates are taken as 0 if v and V are only nearly equal.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v)
{
    Matrix36d result = Matrix36d::Zero();
    if (!v.isApprox(V)) result.rightCols<3>() = cross_matrix(V - v);
    return result;
}

} // namespace rigor
