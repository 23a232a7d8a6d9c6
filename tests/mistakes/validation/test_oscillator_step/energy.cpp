// SPDX-License-Identifier: MIT
// Demands that a step keeps the energy, which few methods do.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    for (int i = 1; i < 20; ++i) {
        const auto [x, v] = step({1, 0.1 * i}, 2, 0.2 / i);
        const double before = 4 + 0.01 * i * i, after = 4 * x * x + v * v;
        if (!(std::abs(after - before) < 1e-9 * before)) return rejected();
    }
    return accepted();
}

} // namespace rigor
