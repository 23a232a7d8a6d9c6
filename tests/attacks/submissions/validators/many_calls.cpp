// SPDX-License-Identifier: MIT
// Calls the formula without end, each time with other arguments.
// topic: validation
// tasks: A8.3
// expect: 0 failed: more than 1000 times
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    for (double angle = 0;; angle += 0.001)
        tangent({std::cos(angle), std::sin(angle), 0});
}

} // namespace rigor
