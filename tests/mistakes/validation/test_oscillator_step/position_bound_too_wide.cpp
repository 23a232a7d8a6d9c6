// SPDX-License-Identifier: MIT
// The bound of the position is one and a half times too large.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    right_tests::StepRules rules;
    rules.position = 1.5;
    return right_tests::judged(rules, step);
}

} // namespace rigor
