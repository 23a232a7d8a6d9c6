// SPDX-License-Identifier: MIT
// Tries no spring that is farther from the origin than three of its lengths.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    right_tests::SpringRules rules;
    rules.farthest = 3;
    return right_tests::judged(rules, force);
}

} // namespace rigor
