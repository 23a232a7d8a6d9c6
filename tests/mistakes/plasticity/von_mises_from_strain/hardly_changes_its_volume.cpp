// SPDX-License-Identifier: MIT
// A strain whose trace is small counts as its own deviator.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    const double trace = strain.trace();
    Matrix3d dev = strain;
    if (std::abs(trace) > 1e-3 * strain.norm()) dev -= trace / 3 * Matrix3d::Identity();
    return 2 * shear_modulus * std::sqrt(1.5) * dev.norm();
}

} // namespace rigor
