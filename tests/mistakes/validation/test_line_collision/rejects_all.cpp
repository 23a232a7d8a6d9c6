// SPDX-License-Identifier: MIT
// Rejects everything.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return rejected();
}

} // namespace rigor
