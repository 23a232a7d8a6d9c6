// SPDX-License-Identifier: MIT
// Asks questions at places in the list of calls that it does not have.
// topic: validation
// tasks: A8.1 A8.2 A8.3
// expect: 0 failed: a question that is none
#include "formulas/validation.hpp"

#include <climits>

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return {0, -1, {1, 2, 3, 0, 0.5}};
}

Judgement test_spring_force(const SpringForce&)
{
    return {0, INT_MIN, {1, 0, 0, 0, 0, 0, 1, 1}};
}

Judgement test_tangent(const Tangent& tangent)
{
    throw UnknownCall{static_cast<int>(tangent.known.size()) + 1, {1, 0, 0}};
}

} // namespace rigor
