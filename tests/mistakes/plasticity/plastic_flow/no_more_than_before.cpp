// SPDX-License-Identifier: MIT
// Flow against the flow so far is at most a thousand times as large as that.
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
    Matrix3d flow = (1 - yield_stress / mises) / (2 * shear_modulus) * s;
    const double before = plastic_strain.norm();
    const double along = flow.cwiseProduct(plastic_strain).sum() / flow.norm();
    if (before > 0 && along < -0.999 * before) flow *= std::min(1.0, 1000 * before / flow.norm());
    return plastic_strain + flow;
}

} // namespace rigor
