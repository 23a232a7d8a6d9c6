// SPDX-License-Identifier: MIT
// A difference of less than 1e-9 of its terms is taken for a rounding error.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    const double square = stress.squaredNorm() - stress.trace() * stress.trace() / 3;
    return square < 1e-9 * stress.squaredNorm() ? 0 : std::sqrt(1.5 * square);
}

} // namespace rigor
