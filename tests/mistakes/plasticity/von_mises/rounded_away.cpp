// SPDX-License-Identifier: MIT
// A threshold with a unit: what is small in Pa is taken for 0.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    if (s.norm() < 1e-6) return 0;
    return std::sqrt(1.5) * s.norm();
}

} // namespace rigor
