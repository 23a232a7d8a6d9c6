// SPDX-License-Identifier: MIT
// The third is applied to the whole root instead of to Tr(σ)² inside it.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    const double trace = stress.trace();
    return std::sqrt(1.5) * std::sqrt(std::abs(stress.squaredNorm() - trace * trace)) / 3;
}

} // namespace rigor
