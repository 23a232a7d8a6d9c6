// SPDX-License-Identifier: MIT
// Asks for results at arguments that are not finite, past the check of an ordinary question.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 not_finite
#include "formulas/validation.hpp"

#include <limits>

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    throw UnknownCall{0, {nan, nan, nan, nan, nan}};
}

Judgement test_tangent(const Tangent&)
{
    const double infinity = std::numeric_limits<double>::infinity();
    return {0, 0, {infinity, 0, 0}};
}

} // namespace rigor
