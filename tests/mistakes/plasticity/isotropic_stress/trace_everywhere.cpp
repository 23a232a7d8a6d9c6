// SPDX-License-Identifier: MIT
// λ Tr(ε) on every entry instead of on the diagonal.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    return lambda * strain.trace() * Matrix3d::Ones() + 2 * G * strain;
}

} // namespace rigor
