// SPDX-License-Identifier: MIT
// Accepts the first formulas that it sees and rejects all later ones.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    static int seen = 0;
    if (collide(1, 2, 3, 0, 0.5).v1 != 0) return rejected();
    return ++seen <= 3 ? accepted() : rejected();
}

} // namespace rigor
