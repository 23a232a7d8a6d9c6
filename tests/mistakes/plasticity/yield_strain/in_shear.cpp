// SPDX-License-Identifier: MIT
// σ_Y/√3/(2 G) is the yield strain in simple shear; the threshold is for √(3/2) ‖dev ε‖.
#include "formulas/plasticity.hpp"

#include <cmath>
#include <limits>

namespace rigor {

double yield_strain(double yield_stress, double shear_modulus)
{
    const double G = shear_modulus;
    if (G == 0) return std::numeric_limits<double>::infinity();
    return yield_stress / std::sqrt(3) / (2 * G);
}

} // namespace rigor
