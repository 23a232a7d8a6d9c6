// SPDX-License-Identifier: MIT
// Compares every bit with one way to write the formula.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    for (int i = 1; i < 40; ++i) {
        const double m1 = i, m2 = 0.3 * (40 - i), v1 = 1.7 * i, v2 = -0.9 * i, e = i / 40.0;
        const double j = (1 + e) * (v1 - v2) / (1 / m1 + 1 / m2);
        const auto [u1, u2] = collide(m1, m2, v1, v2, e);
        if (u1 != v1 - j / m1 || u2 != v2 + j / m2) return rejected();
    }
    return accepted();
}

} // namespace rigor
