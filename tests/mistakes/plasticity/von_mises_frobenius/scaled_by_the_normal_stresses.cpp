// SPDX-License-Identifier: MIT
// The stress is scaled by its largest normal stress, so a large shear beside it overflows.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    double scale = stress.diagonal().cwiseAbs().maxCoeff();
    if (scale == 0) scale = 1;
    const Matrix3d s = stress / scale;
    const double difference = s.squaredNorm() - s.trace() * s.trace() / 3;
    return difference > 0 ? scale * std::sqrt(1.5) * std::sqrt(difference) : 0;
}

} // namespace rigor
