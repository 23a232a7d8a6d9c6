// SPDX-License-Identifier: MIT
// Asks the first question anew each time, with other arguments.
// topic: validation
// tasks: A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    static double angle = 0;
    angle += 0.001;
    tangent({std::cos(angle), std::sin(angle), 0});
    return accepted();
}

} // namespace rigor
