// SPDX-License-Identifier: MIT
// λ is used as if it were the bulk modulus: 2 G acts on the deviator only, not on all of ε.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    const Matrix3d e = strain - strain.trace() / 3 * Matrix3d::Identity();
    return lambda * strain.trace() * Matrix3d::Identity() + 2 * G * e;
}

} // namespace rigor
