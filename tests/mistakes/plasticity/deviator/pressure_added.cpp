// SPDX-License-Identifier: MIT
// The sign of a pressure, which is minus the mean stress, used twice.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress + stress.trace() / 3 * Matrix3d::Identity();
}

} // namespace rigor
