// SPDX-License-Identifier: MIT
// Compares with the exact motion and leaves no room for the error of a method.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    for (int i = 1; i < 60; ++i) {
        const double a = 0.5 / i;
        const OscillatorState s = step({1, 0}, 1, a);
        if (!(std::abs(s.x - std::cos(a)) < 1e-9)) return rejected();
    }
    return accepted();
}

} // namespace rigor
