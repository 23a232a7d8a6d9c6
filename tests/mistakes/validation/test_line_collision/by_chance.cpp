// SPDX-License-Identifier: MIT
// Draws other cases in each run, so that its questions are never all answered.
#include "formulas/validation.hpp"

#include <chrono>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    for (int i = 0; i < 40; ++i) {
        const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
        if (collide(1, 2, 1e-9 * static_cast<double>(now), 0, 1).v2 < 0) return rejected();
    }
    return accepted();
}

} // namespace rigor
