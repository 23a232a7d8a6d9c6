// SPDX-License-Identifier: MIT
// Allows no rounding where the bodies do not approach.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    right_tests::CollisionRules rules;
    rules.is_exact_where_apart = true;
    return right_tests::judged(rules, collide);
}

} // namespace rigor
