// SPDX-License-Identifier: MIT
// A stress far below the largest one counts as 0, as if the surface were free.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_principal(double stress1, double stress2, double stress3)
{
    Vector3d sigma(stress1, stress2, stress3);
    const double largest = sigma.cwiseAbs().maxCoeff();
    for (double& stress : sigma)
        if (std::abs(stress) < 1e-6 * largest) stress = 0;
    return Vector3d(sigma[0] - sigma[1], sigma[1] - sigma[2], sigma[2] - sigma[0]).norm() /
           std::sqrt(2.0);
}

} // namespace rigor
