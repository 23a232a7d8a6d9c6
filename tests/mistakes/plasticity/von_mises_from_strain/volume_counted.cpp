// SPDX-License-Identifier: MIT
// The change of volume counts, so that equal stretch in all directions would yield.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const double G = shear_modulus;
    return 2 * G * std::sqrt(1.5) * strain.norm();
}

} // namespace rigor
