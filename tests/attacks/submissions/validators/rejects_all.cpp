// SPDX-License-Identifier: MIT
// Rejects whatever comes, with line numbers that no file has.
// topic: validation
// tasks: A8.1 A8.3 A8.5
// expect: 0 failed: rejects a formula that is right
#include "formulas/validation.hpp"

#include <climits>

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return rejected(INT_MIN);
}

Judgement test_tangent(const Tangent&)
{
    return rejected(-1);
}

Judgement test_units(const UnknownFormula&, const std::vector<double>&,
                     const std::vector<Dimension>&, const std::vector<Dimension>&)
{
    return rejected(INT_MAX);
}

} // namespace rigor
