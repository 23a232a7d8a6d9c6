// SPDX-License-Identifier: MIT
// Shear is left out where it is small beside the pressure, long before rounding hides it.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const double result = std::sqrt(1.5) * deviator(stress).norm();
    return result < 1e-12 * stress.norm() ? 0 : result;
}

} // namespace rigor
