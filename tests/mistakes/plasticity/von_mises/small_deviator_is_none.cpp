// SPDX-License-Identifier: MIT
// A small deviator counts as 0, although its square is a double.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d dev = stress - stress.trace() / 3 * Matrix3d::Identity();
    const double largest = dev.cwiseAbs().maxCoeff();
    if (largest < 1e-120) return 0; // nothing to divide by
    return std::sqrt(1.5) * largest * (dev / largest).norm();
}

} // namespace rigor
