// SPDX-License-Identifier: MIT
// Tries no spring without stiffness, and none without a rest length.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    right_tests::SpringRules rules;
    rules.tries_zeros = false;
    return right_tests::judged(rules, force);
}

} // namespace rigor
