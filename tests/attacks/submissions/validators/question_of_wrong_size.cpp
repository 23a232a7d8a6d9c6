// SPDX-License-Identifier: MIT
// Asks questions with more numbers than the formula has arguments, and with fewer.
// topic: validation
// tasks: A8.1 A8.2 A8.3
// expect: 0 failed: a question that is none
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return {0, 0, {1, 2, 3}};
}

Judgement test_spring_force(const SpringForce&)
{
    throw UnknownCall{0, std::vector<double>(1 << 17, 1)};
}

Judgement test_tangent(const Tangent&)
{
    return {1, 0, {1}};
}

} // namespace rigor
