// SPDX-License-Identifier: MIT
// Draws every restitution but exactly 0 and 1.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    right_tests::CollisionRules rules;
    rules.tries_ends = false;
    return right_tests::judged(rules, collide);
}

} // namespace rigor
