// SPDX-License-Identifier: MIT
// G ε for 2 G ε: the engineer's shear γ = 2 ε mixed up with the tensor's.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double lambda = lame_lambda, G = shear_modulus;
    return lambda * strain.trace() * Matrix3d::Identity() + G * strain;
}

} // namespace rigor
