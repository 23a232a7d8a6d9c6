// SPDX-License-Identifier: MIT
// A turn by less than a millionth is taken as none.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    if (R.isApprox(Matrix3d::Identity(), 1e-6)) return I_body;
    return R * I_body * R.transpose();
}

} // namespace rigor
