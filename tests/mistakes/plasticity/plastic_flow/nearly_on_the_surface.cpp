// SPDX-License-Identifier: MIT
// A stress within 1e-12 of the yield surface counts as on it, although that is thousands of times
// its rounding.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = deviator(stress);
    const double f = std::sqrt(1.5) * s.norm() - yield_stress;
    if (f <= 1e-12 * yield_stress || shear_modulus == 0) return plastic_strain;
    return plastic_strain + f / (3 * shear_modulus) * std::sqrt(1.5) * s / s.norm();
}

} // namespace rigor
