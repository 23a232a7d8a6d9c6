// SPDX-License-Identifier: MIT
// Entries below a billionth of the stress are set to 0.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    for (int i = 0; i < 9; ++i)
        if (std::abs(s(i)) < 1e-9 * stress.norm()) s(i) = 0;
    return s;
}

} // namespace rigor
