// SPDX-License-Identifier: MIT
// Halves the angle of the step again and again, and tries none between.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_oscillator_step(const OscillatorStep& step)
{
    right_tests::StepRules rules;
    rules.draws_between = false;
    return right_tests::judged(rules, step);
}

} // namespace rigor
