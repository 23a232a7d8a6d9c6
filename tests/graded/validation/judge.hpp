// SPDX-License-Identifier: MIT
// Tries the test that a student wrote on right and wrong formulas. The formulas stay in this
// process; the test, in its worker, gets nothing but their results, and says whether it accepts
// them. Each formula is judged by a new worker, in an order that is drawn, so that a test can
// neither remember an earlier formula nor know which ones come first.
#pragma once

#include "numeric_formula.hpp"

#include <string>
#include <vector>

namespace rigor::testing {

/// A student's test of a formula with this many numbers as arguments.
struct StudentsTest {
    std::function<Judgement(const std::vector<KnownCall>& known)> judgement;
    std::size_t arguments = 0;
};

template <class Result, class... Argument>
StudentsTest students_test(Judgement (*test)(const UnderTest<Result, Argument...>&))
{
    return {[test](const std::vector<KnownCall>& known) {
                UnderTest<Result, Argument...> formula;
                formula.known = known;
                return test(formula);
            },
            (sizeof(Argument) + ...) / sizeof(double)};
}

/// `test_units` for a formula with these dimensions.
StudentsTest students_test_of_units(const FormulaWithUnits& formula);

/// What the failure of a test case tells of the texts that a student's test throws or prints,
/// and of the line in which it rejects a formula. They can quote the calls of a formula with their
/// results, which for the hidden formulas nobody is to learn.
enum class Texts { told, kept };

/// Fails unless the test accepts each right formula and rejects each wrong one. A test that rejects
/// a right formula is told so, and nothing about the wrong ones: so nothing is gained by rejecting
/// everything.
void check_test(const StudentsTest& test, const std::vector<NumericFormula>& right,
                const std::vector<WrongNumeric>& wrong, Texts texts = Texts::told);

/// The same for the test of units, whose formulas have dimensions of their own. Each wrong formula
/// comes with a right one, which is tried as well.
void check_test_of_units(const std::vector<FormulaWithUnits>& right,
                         const std::vector<FormulaWithUnits>& wrong, Texts texts = Texts::told);

} // namespace rigor::testing
