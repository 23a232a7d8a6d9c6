// SPDX-License-Identifier: MIT
// Stresses that agree in twelve digits are taken as equal, although their difference is exact.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const Vector3d sigma(stress1, stress2, stress3);
    if (sigma.maxCoeff() - sigma.minCoeff() <= 1e-12 * sigma.cwiseAbs().maxCoeff()) return 0;
    return Vector3d(stress1 - stress2, stress2 - stress3, stress3 - stress1).norm() /
           std::sqrt(2.0);
}

} // namespace rigor
