// SPDX-License-Identifier: MIT
// ‖ε‖² - ⅓ Tr(ε)² is used unless nearly all of its digits cancel; but half of them are too many.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const double trace = strain.trace(), whole = strain.squaredNorm();
    double square = whole - trace * trace / 3;
    if (square <= 1e-9 * whole) square = (strain - trace / 3 * Matrix3d::Identity()).squaredNorm();
    return 2 * shear_modulus * std::sqrt(1.5 * square);
}

} // namespace rigor
