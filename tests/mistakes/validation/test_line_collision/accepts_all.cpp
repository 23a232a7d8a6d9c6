// SPDX-License-Identifier: MIT
// Accepts everything.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return accepted();
}

} // namespace rigor
