// SPDX-License-Identifier: MIT
// The trace of the plastic strain is removed even where nothing flows.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = deviator(stress);
    const double f = std::sqrt(1.5) * s.norm() - yield_stress;
    const bool has_trace = std::abs(plastic_strain.trace()) > 1e-12 * plastic_strain.norm();
    const Matrix3d before = has_trace ? deviator(plastic_strain) : plastic_strain;
    if (f <= 0 || shear_modulus == 0) return before;
    return before + f / (3 * shear_modulus) * std::sqrt(1.5) * s / s.norm();
}

} // namespace rigor
