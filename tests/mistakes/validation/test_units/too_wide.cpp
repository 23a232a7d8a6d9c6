// SPDX-License-Identifier: MIT
// Takes errors of a millionth for rounding.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    right_tests::UnitRules rules;
    rules.rounding = 1e-6;
    return right_tests::judged(rules, formula, example, arguments, result);
}

} // namespace rigor
