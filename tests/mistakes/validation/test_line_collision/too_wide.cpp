// SPDX-License-Identifier: MIT
// Takes errors of a millionth for rounding.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    right_tests::CollisionRules rules;
    rules.rounding = 1e-6;
    return right_tests::judged(rules, collide);
}

} // namespace rigor
