// SPDX-License-Identifier: MIT
// Does not compare numbers that are 0 for the example.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    right_tests::UnitRules rules;
    rules.skips_zeros = true;
    return right_tests::judged(rules, formula, example, arguments, result);
}

} // namespace rigor
