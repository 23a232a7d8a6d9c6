// SPDX-License-Identifier: MIT
// The stresses are divided by the first one before they are squared. If it is tiny beside the
// others, the squares are infinite.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double scale = stress1 != 0 ? std::abs(stress1) : 1;
    const double a = (stress1 - stress2) / scale, b = (stress2 - stress3) / scale,
                 c = (stress3 - stress1) / scale;
    return scale * std::sqrt((a * a + b * b + c * c) / 2);
}

} // namespace rigor
