// SPDX-License-Identifier: MIT
// A von Mises stress below 1e-60 Pa counts as none.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double a = stress1 - stress2, b = stress2 - stress3, c = stress3 - stress1;
    const double square = (a * a + b * b + c * c) / 2;
    return square < 1e-120 ? 0 : std::sqrt(square);
}

} // namespace rigor
