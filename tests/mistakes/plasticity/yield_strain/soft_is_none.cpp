// SPDX-License-Identifier: MIT
// A small shear modulus counts as 0, although its square is a double.
#include "formulas/plasticity.hpp"

#include <limits>

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    if (shear_modulus < 1e-110) return std::numeric_limits<double>::infinity();
    return yield_stress / (2 * shear_modulus);
}

} // namespace rigor
