// SPDX-License-Identifier: MIT
// Demands that energy is kept, whatever the restitution.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    for (int i = 1; i < 40; ++i) {
        const double m1 = i, m2 = 3, v1 = 2, v2 = -i;
        const auto [u1, u2] = collide(m1, m2, v1, v2, i / 40.0);
        const double before = m1 * v1 * v1 + m2 * v2 * v2, after = m1 * u1 * u1 + m2 * u2 * u2;
        if (!(std::abs(after - before) < 1e-9 * before)) return rejected();
    }
    return accepted();
}

} // namespace rigor
