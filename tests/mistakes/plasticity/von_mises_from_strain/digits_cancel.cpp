// SPDX-License-Identifier: MIT
// In ‖ε‖² - ⅓ Tr(ε)² the digits of a small shear cancel beside a large change of volume.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    if (strain == strain(0, 0) * Matrix3d::Identity()) return 0;
    const double trace = strain.trace();
    const double square = std::max(0.0, strain.squaredNorm() - trace * trace / 3);
    return 2 * shear_modulus * std::sqrt(1.5 * square);
}

} // namespace rigor
