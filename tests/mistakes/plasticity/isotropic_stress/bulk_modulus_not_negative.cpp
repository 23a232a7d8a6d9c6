// SPDX-License-Identifier: MIT
// The bulk modulus λ + 2 G/3 is kept at 0 where a strongly negative λ would make it negative.
#include "formulas/plasticity.hpp"

#include <algorithm>

namespace rigor {

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    const double bulk = std::max(0.0, lame_lambda + 2 * shear_modulus / 3);
    const double trace = strain.trace();
    return 2 * shear_modulus * (strain - trace / 3 * Matrix3d::Identity()) +
           bulk * trace * Matrix3d::Identity();
}

} // namespace rigor
