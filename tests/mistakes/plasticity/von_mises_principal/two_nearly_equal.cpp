// SPDX-License-Identifier: MIT
// If two stresses differ by less than a millionth, the answer is how far the third one is.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    if (std::abs(stress1 - stress2) < 1e-6 * std::abs(stress1)) return std::abs(stress1 - stress3);
    return Vector3d(stress1 - stress2, stress2 - stress3, stress3 - stress1).norm() /
           std::sqrt(2.0);
}

} // namespace rigor
