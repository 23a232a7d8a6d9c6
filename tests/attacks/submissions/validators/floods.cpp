// SPDX-License-Identifier: MIT
// Asks a question of thirty megabytes, past the formula, which would not send it.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 failed: at most 1048576 are allowed
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    throw UnknownCall{0, std::vector<double>(4'000'000, 1)};
}

Judgement test_tangent(const Tangent&)
{
    return {0, 0, std::vector<double>(4'000'000, 1)};
}

} // namespace rigor
