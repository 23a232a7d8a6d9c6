// SPDX-License-Identifier: MIT
// Symmetric tensors of every structure: with any of the entries beside the diagonal zero, positive
// or negative, and a diagonal of any order and sign, also with equal entries, in which any entry or
// any eigenvalue may be the largest. All entries are dyadic, so that small sums are exact.
#pragma once

#include "formulas/types.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing {

/// All these tensors: 125 diagonals, times 27 patterns of signs and zeros, times two sizes of the
/// entries beside the diagonal.
inline std::vector<Matrix3d> tensor_patterns()
{
    const Vector3d sizes[] = {{0.25, 4, 0.5}, {1, 1, 1}};
    constexpr double on_diagonal[] = {-3, -1, 0, 1, 4};
    std::vector<Matrix3d> result;
    for (const Vector3d& size : sizes)
        for (int i = 0; i < 125; ++i)
            for (int signs = 0; signs < 27; ++signs) {
                const double xy = (signs % 3 - 1) * size[0], yz = (signs / 3 % 3 - 1) * size[1],
                             zx = (signs / 9 - 1) * size[2];
                Matrix3d A;
                A << on_diagonal[i % 5], xy, zx,    //
                    xy, on_diagonal[i / 5 % 5], yz, //
                    zx, yz, on_diagonal[i / 25];
                result.push_back(A);
            }
    return result;
}

/// The smallest principal minor of A/size, for a symmetric matrix A. No eigenvalue of A is negative
/// exactly if no principal minor is.
inline double smallest_minor(const Matrix3d& A, double size)
{
    double smallest = A.determinant() / (size * size * size);
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        const double two = A(i, i) * A(k, k) - A(i, k) * A(k, i);
        smallest = std::min({smallest, A(i, i) / size, two / (size * size)});
    }
    return smallest;
}

} // namespace rigor::testing
