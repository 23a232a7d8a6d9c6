// SPDX-License-Identifier: MIT
// A deviator below 1e-12 Pa counts as zero.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    const double f = std::sqrt(1.5) * s.norm() - yield_stress;
    if (f <= 0 || shear_modulus == 0) return plastic_strain;
    if (s.norm() < 1e-12) return plastic_strain;
    return plastic_strain + f / (3 * shear_modulus) * std::sqrt(1.5) * s / s.norm();
}

} // namespace rigor
