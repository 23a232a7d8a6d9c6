// SPDX-License-Identifier: MIT
// A body whose moments differ by less than a millionth is taken as a ball.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    if (I_body.isApprox(I_body(0, 0) * Matrix3d::Identity(), 1e-6)) return I_body;
    return R * I_body * R.transpose();
}

} // namespace rigor
