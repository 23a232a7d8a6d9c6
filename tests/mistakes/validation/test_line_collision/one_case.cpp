// SPDX-License-Identifier: MIT
// Checks a single case by hand.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    const auto [u1, u2] = collide(1, 1, 2, 0, 1);
    return std::abs(u1) < 1e-12 && std::abs(u2 - 2) < 1e-12 ? accepted() : rejected();
}

} // namespace rigor
