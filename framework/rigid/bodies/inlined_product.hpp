// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

namespace rigor::optimised {

/// The product A x as a sum over the columns of A. The compiler does not inline Eigen's product.
[[gnu::always_inline]] inline Vector3d product(const Matrix3d& A, const Vector3d& x)
{
    return x.x() * A.col(0) + x.y() * A.col(1) + x.z() * A.col(2);
}

} // namespace rigor::optimised
