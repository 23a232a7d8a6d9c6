// SPDX-License-Identifier: MIT
// Allows for less rounding than a right formula may have: 1e-14 times the larger speed.
#include "formulas/validation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    std::mt19937 bits(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 300; ++i) {
        const double size = std::pow(10, 12 * uniform(bits) - 6);
        const double m1 = size * uniform(bits), m2 = uniform(bits),
                     e = i % 4 == 0 ? 0 : uniform(bits);
        const double v1 = size * (2 * uniform(bits) - 1), v2 = size * (2 * uniform(bits) - 1);
        const auto [u1, u2] = collide(m1, m2, v1, v2, e);
        if (v1 <= v2) {
            if (u1 != v1 || u2 != v2) return rejected();
            continue;
        }
        const double v = std::max(std::abs(v1), std::abs(v2)), allowed = 1e-14 * v;
        if (!(std::abs(u1 - u2 + e * (v1 - v2)) <= allowed)) return rejected();
        if (!(std::abs(m1 * (u1 - v1) + m2 * (u2 - v2)) <= (m1 + m2) * allowed)) return rejected();
    }
    return accepted();
}

} // namespace rigor
