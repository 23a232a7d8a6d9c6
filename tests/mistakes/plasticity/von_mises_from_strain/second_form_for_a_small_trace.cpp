// SPDX-License-Identifier: MIT
// A trace that is small, but not beside the deviator, is taken as no danger for √(‖ε‖² - ⅓ Tr(ε)²).
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    if (std::abs(strain.trace()) < 1e-3) return 2 * shear_modulus * von_mises_frobenius(strain);
    return von_mises(2 * shear_modulus * strain);
}

} // namespace rigor
