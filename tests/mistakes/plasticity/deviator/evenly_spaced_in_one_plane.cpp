// SPDX-License-Identifier: MIT
// Where the diagonal is evenly spaced and only the shear zx is not 0, this shear is lost.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    const bool is_even = s(1, 1) == 0 && s(0, 0) > 0 && s(0, 1) == 0 && s(1, 2) == 0;
    return is_even ? Matrix3d(s.diagonal().asDiagonal()) : s;
}

} // namespace rigor
