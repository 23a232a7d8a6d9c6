// SPDX-License-Identifier: MIT
// Only 0/0 is treated. A shear modulus of -0, which is zero, gives minus infinity.
#include "formulas/plasticity.hpp"

#include <limits>

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    if (yield_stress == 0 && shear_modulus == 0) return std::numeric_limits<double>::infinity();
    return yield_stress / (2 * shear_modulus);
}

} // namespace rigor
