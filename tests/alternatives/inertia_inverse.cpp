// SPDX-License-Identifier: MIT
// The inverse of R instead of its transpose.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * (I_body * R.inverse());
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * (I_body_inverse * R.inverse());
}

} // namespace rigor
