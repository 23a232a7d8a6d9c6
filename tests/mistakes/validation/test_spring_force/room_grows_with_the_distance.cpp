// SPDX-License-Identifier: MIT
// Allows an error that grows with the distance of the spring from the origin.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    right_tests::SpringRules rules;
    rules.room_grows = true;
    return right_tests::judged(rules, force);
}

} // namespace rigor
