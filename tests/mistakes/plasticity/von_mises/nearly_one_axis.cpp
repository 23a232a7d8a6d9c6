// SPDX-License-Identifier: MIT
// Two principal stresses that are nearly equal are taken for equal, and the result is the
// difference to the third.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d s = deviator(stress);
    const Vector3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(s, Eigen::EigenvaluesOnly)
                              .eigenvalues(); // in ascending order
    const double range = axes[2] - axes[0];
    if (axes[1] - axes[0] <= 1e-8 * range || axes[2] - axes[1] <= 1e-8 * range) return range;
    return std::sqrt(1.5) * s.norm();
}

} // namespace rigor
