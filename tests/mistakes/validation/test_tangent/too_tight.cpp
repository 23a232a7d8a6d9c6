// SPDX-License-Identifier: MIT
// Allows for less rounding than a right formula may have: 1e-14.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    for (int i = 0; i < 300; ++i) {
        const double x = i % 7 - 3, y = i % 11 - 5, z = i % 13 - 6;
        if (x == 0 && y == 0 && z == 0) continue;
        const Vector3d n = Vector3d(x, y, z).normalized(), t = tangent(n);
        if (!(std::abs(t.norm() - 1) <= 1e-14)) return rejected();
        if (!(std::abs(t.dot(n)) <= 1e-14)) return rejected();
    }
    return accepted();
}

} // namespace rigor
