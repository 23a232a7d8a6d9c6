// SPDX-License-Identifier: MIT
// A deviator far below the pressure counts as its rounding error.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const double mises = von_mises(stress);
    if (mises <= 1e-10 * std::abs(stress.trace())) return plastic_strain;
    if (mises <= yield_stress || shear_modulus == 0) return plastic_strain;
    return plastic_strain + (1 - yield_stress / mises) / (2 * shear_modulus) * deviator(stress);
}

} // namespace rigor
