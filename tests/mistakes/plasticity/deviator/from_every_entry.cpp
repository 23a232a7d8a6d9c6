// SPDX-License-Identifier: MIT
// The pressure taken from every entry, from the shears too.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    return stress - stress.trace() / 3 * Matrix3d::Ones();
}

} // namespace rigor
