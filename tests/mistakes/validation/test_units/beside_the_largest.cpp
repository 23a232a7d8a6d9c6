// SPDX-License-Identifier: MIT
// Errors are relative to the largest number, so the small ones are not compared.
#include "mistakes/validation/right_tests.hpp"

namespace rigor {

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    right_tests::UnitRules rules;
    rules.beside_largest = true;
    return right_tests::judged(rules, formula, example, arguments, result);
}

} // namespace rigor
