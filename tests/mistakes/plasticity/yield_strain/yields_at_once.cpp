// SPDX-License-Identifier: MIT
// 0 where G = 0: it would yield always instead of never.
#include "formulas/plasticity.hpp"

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    return G == 0 ? 0 : yield_stress / (2 * G);
}

} // namespace rigor
