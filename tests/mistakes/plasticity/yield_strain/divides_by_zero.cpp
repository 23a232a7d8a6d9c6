// SPDX-License-Identifier: MIT
// 0/0 where neither strength nor stiffness is left.
#include "formulas/plasticity.hpp"

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    return yield_stress / (2 * G);
}

} // namespace rigor
