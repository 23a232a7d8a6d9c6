// SPDX-License-Identifier: MIT
// The inverse of a rod's inertia is given, with a 0 in it, and cannot be inverted back: turn it as it is.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    const Matrix3d I = R * I_body_inverse.inverse() * R.transpose();
    return I.inverse();
}

} // namespace rigor
