// SPDX-License-Identifier: MIT
// The ½ is outside the root: ½ √(…) instead of √(½ …).
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double a = stress1 - stress2, b = stress2 - stress3, c = stress3 - stress1;
    return 0.5 * std::sqrt(a * a + b * b + c * c);
}

} // namespace rigor
