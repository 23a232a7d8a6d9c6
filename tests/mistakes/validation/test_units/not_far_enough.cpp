// SPDX-License-Identifier: MIT
// Changes the units by factors up to 2^32, and not up to 2^40.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    right_tests::UnitRules rules;
    rules.largest_power = 32;
    return right_tests::judged(rules, formula, example, arguments, result);
}

} // namespace rigor
