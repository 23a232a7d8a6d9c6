// SPDX-License-Identifier: MIT
// Beside a shear more than 1000 times as large, the diagonal of the deviator is left out.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    Matrix3d d = deviator(stress);
    const double shear = std::max({std::abs(d(0, 1)), std::abs(d(1, 2)), std::abs(d(0, 2))});
    if (d.diagonal().cwiseAbs().maxCoeff() < 1e-3 * shear) d.diagonal().setZero();
    return std::sqrt(1.5) * d.norm();
}

} // namespace rigor
