// SPDX-License-Identifier: MIT
// The trace is a sum of all entries minus the shears, which lose its digits if they are large.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    // One sum over the nine entries, which the compiler can vectorize, without the shears.
    const double trace = stress.sum() - 2 * (stress(0, 1) + stress(1, 2) + stress(0, 2));
    return stress - trace / 3 * Matrix3d::Identity();
}

} // namespace rigor
