// SPDX-License-Identifier: MIT
// A solid with a yield stress keeps at least 1e-10 of the stress that yielded, however weak it is.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    const double mises = std::sqrt(1.5) * s.norm();
    if (mises <= yield_stress || shear_modulus == 0) return plastic_strain;
    const double kept = yield_stress > 0 ? std::max(yield_stress / mises, 1e-10) : 0;
    return plastic_strain + (1 - kept) / (2 * shear_modulus) * s;
}

} // namespace rigor
