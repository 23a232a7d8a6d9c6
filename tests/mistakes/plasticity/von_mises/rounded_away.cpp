// SPDX-License-Identifier: MIT
// The threshold is an absolute number of pascals, so that small stresses become 0.
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
