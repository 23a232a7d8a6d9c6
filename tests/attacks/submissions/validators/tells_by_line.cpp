// SPDX-License-Identifier: MIT
// Rejects formulas in a line whose number tells the dimensions of their arguments, also where the
// formulas are hidden.
// topic: validation
// tasks: A8.6
// expect: 0 failed|not_implemented
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_units(const UnknownFormula&, const std::vector<double>&,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>&)
{
    int line = 1;
    for (const Dimension& d : arguments)
        line =
            (7 * 49 * line + 49 * (d.mass + 3) + 7 * (d.length + 3) + d.time + 3) % 1'000'000'007;
    return rejected(line);
}

} // namespace rigor
