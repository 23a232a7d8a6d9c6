// SPDX-License-Identifier: MIT
// A trace that is small, but not beside the deviator, is taken as no danger for √(‖σ‖² - ⅓ Tr(σ)²).
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    if (std::abs(stress.trace()) < 1e-3) return von_mises_frobenius(stress);
    return std::sqrt(1.5) * deviator(stress).norm();
}

} // namespace rigor
