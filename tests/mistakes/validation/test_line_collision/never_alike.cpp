// SPDX-License-Identifier: MIT
// Tries no bodies that move alike.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    right_tests::CollisionRules rules;
    rules.tries_equal = false;
    return right_tests::judged(rules, collide);
}

} // namespace rigor
