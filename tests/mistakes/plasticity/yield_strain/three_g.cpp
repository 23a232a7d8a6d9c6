// SPDX-License-Identifier: MIT
// 3 G belongs to the flow, not here.
#include "formulas/plasticity.hpp"

#include <limits>

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    if (G == 0) return std::numeric_limits<double>::infinity();
    return yield_stress / (3 * G);
}

} // namespace rigor
