// SPDX-License-Identifier: MIT
// Tries one step size, and so learns nothing about the order.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    for (int i = 0; i < 60; ++i) {
        const double x = std::sin(i), v = std::cos(2 * i), w = 0.5 + 0.1 * i, a = 0.5;
        const OscillatorState s = step({x, v}, w, a / w);
        const double bound = a * a * a * std::hypot(x, v / w);
        if (!(std::abs(s.x - x * std::cos(a) - v / w * std::sin(a)) <= bound)) return rejected();
        if (!(std::abs(s.v - v * std::cos(a) + w * x * std::sin(a)) <= w * bound))
            return rejected();
    }
    return accepted();
}

} // namespace rigor
