// SPDX-License-Identifier: MIT
// Checks that momentum is kept, and not the restitution.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    for (int i = 1; i < 40; ++i) {
        const double m1 = i, m2 = 40 - i, v1 = i, v2 = -0.5 * i * i;
        const auto [u1, u2] = collide(m1, m2, v1, v2, i / 40.0);
        if (!(std::abs(m1 * (u1 - v1) + m2 * (u2 - v2)) < 1e-9 * i * i * m2)) return rejected();
    }
    return accepted();
}

} // namespace rigor
