// SPDX-License-Identifier: MIT
// A soft solid counts as one without stiffness, so that it does not flow.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const double mises = von_mises(stress), f = mises - yield_stress;
    if (f <= 0 || shear_modulus < 1e-6 * yield_stress) return plastic_strain;
    return plastic_strain + f / (2 * shear_modulus * mises) * deviator(stress);
}

} // namespace rigor
