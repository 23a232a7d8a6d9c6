// SPDX-License-Identifier: MIT
// A change of volume of less than a millionth of the strain is ignored.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const Matrix3d sigma = 2 * shear_modulus * strain;
    if (std::abs(strain.trace()) < 1e-6 * strain.norm()) return sigma;
    return sigma + lame_lambda * strain.trace() * Matrix3d::Identity();
}

} // namespace rigor
