// SPDX-License-Identifier: MIT
// The bound of the velocity is twice too large.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    right_tests::StepRules rules;
    rules.velocity = 2;
    return right_tests::judged(rules, step);
}

} // namespace rigor
