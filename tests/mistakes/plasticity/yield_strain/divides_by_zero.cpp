// SPDX-License-Identifier: MIT
// If yield stress and shear modulus are both zero, the result is 0/0.
#include "formulas/plasticity.hpp"

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    return yield_stress / (2 * G);
}

} // namespace rigor
