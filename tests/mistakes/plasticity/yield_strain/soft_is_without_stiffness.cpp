// SPDX-License-Identifier: MIT
// A shear modulus of at most 1e-100 Pa counts as none.
#include "formulas/plasticity.hpp"

#include <limits>

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    if (shear_modulus <= 1e-100) return std::numeric_limits<double>::infinity();
    return yield_stress / (2 * shear_modulus);
}

} // namespace rigor
