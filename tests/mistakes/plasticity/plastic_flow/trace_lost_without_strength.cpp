// SPDX-License-Identifier: MIT
// With a yield stress of 0 the flow starts from a strain whose trace was removed.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const double mises = von_mises(stress), f = mises - yield_stress;
    if (f <= 0 || shear_modulus == 0) return plastic_strain;
    const Matrix3d flow = f / (2 * shear_modulus * mises) * deviator(stress);
    return (yield_stress == 0 ? deviator(plastic_strain) : plastic_strain) + flow;
}

} // namespace rigor
