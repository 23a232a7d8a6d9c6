// SPDX-License-Identifier: MIT
// Accepts whatever comes.
// topic: validation
// tasks: A8.1 A8.3 A8.5
// expect: 0 failed|not_implemented
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision&)
{
    return accepted();
}

Judgement test_tangent(const Tangent&)
{
    return {};
}

Judgement test_units(const UnknownFormula&, const std::vector<double>&,
                     const std::vector<Dimension>&, const std::vector<Dimension>&)
{
    return accepted();
}

} // namespace rigor
