// SPDX-License-Identifier: MIT
// The largest singular value is used instead of the Frobenius norm.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double von_mises_frobenius(const Matrix3d& stress)
{
    const double trace = stress.trace();
    const double norm = stress.operatorNorm();
    return std::sqrt(1.5) * std::sqrt(std::max(norm * norm - trace * trace / 3, 0.0));
}

} // namespace rigor
