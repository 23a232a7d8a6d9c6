// SPDX-License-Identifier: MIT
// The same number as a sum of products σ₁ (σ₁ - σ₂), in which digits cancel under pressure.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double square = stress1 * (stress1 - stress2) + stress2 * (stress2 - stress3) +
                          stress3 * (stress3 - stress1);
    return square > 0 ? std::sqrt(square) : 0;
}

} // namespace rigor
