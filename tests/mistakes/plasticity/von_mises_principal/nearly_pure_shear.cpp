// SPDX-License-Identifier: MIT
// If the middle stress is halfway up to 3e-4 of the largest difference, it counts as pure shear.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const double a = stress1 - stress2, b = stress2 - stress3, c = stress3 - stress1;
    const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
    const double smallest = std::min({std::abs(a), std::abs(b), std::abs(c)});
    if (std::abs(smallest - largest / 2) < 3e-4 * largest) return std::sqrt(3.0) / 2 * largest;
    return std::sqrt((a * a + b * b + c * c) / 2);
}

} // namespace rigor
