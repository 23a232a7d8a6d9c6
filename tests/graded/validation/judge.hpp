// SPDX-License-Identifier: MIT
// Tries the test that a student wrote on right and wrong formulas. The formulas stay in this
// process; the test, in its worker, gets nothing but their results, and says whether it accepts
// them. Each formula is judged by a new worker, in an order that is drawn, so that a test can
// neither remember an earlier formula nor know which ones come first.
#pragma once

#include "candidates.hpp"

#include <string>
#include <vector>

namespace rigor::testing {

/// A formula as a function from numbers to numbers.
using NumericFormula = Function<UnknownFormula>;

template <class Result, class... Argument>
NumericFormula numeric(const std::function<Result(Argument...)>& formula)
{
    return [formula](const std::vector<double>& from) {
        std::tuple<Argument...> arguments;
        std::size_t at = 0;
        std::apply([&](auto&... argument) { (numbers::take(argument, from, at), ...); }, arguments);
        std::vector<double> result;
        numbers::append(result, std::apply(formula, arguments));
        return result;
    };
}

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

struct WrongNumeric {
    std::string clue; // empty if nothing is to be said
    NumericFormula formula;
};

template <class Formula>
std::vector<WrongNumeric> numeric(const std::vector<WrongFormula<Formula>>& formulas)
{
    std::vector<WrongNumeric> all;
    for (const WrongFormula<Formula>& wrong : formulas)
        all.push_back({wrong.clue, numeric(wrong.formula)});
    return all;
}

template <class Formula>
std::vector<NumericFormula> numeric(const std::vector<std::function<Formula>>& formulas)
{
    std::vector<NumericFormula> all;
    for (const auto& formula : formulas)
        all.push_back(numeric(formula));
    return all;
}

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

/// A right formula whose results have rounding errors nearly as large as A8 allows.
/// @param largest_terms  for these arguments, the largest term of each number of the result,
///                       or 0 if the number is exact
NumericFormula
rounded(const NumericFormula& formula,
        const std::function<std::vector<double>(const std::vector<double>&)>& largest_terms);

/// Wrong formulas that a program makes of a right one: a number of the result is scaled, has the
/// other sign, is that of the call before, or is wrong beyond a threshold; an argument is ignored,
/// or two are exchanged. Each differs clearly from the right formula for a quarter of the arguments
/// that `draw` gives, or more.
std::vector<WrongNumeric> mutants(const NumericFormula& formula,
                                  const std::function<std::vector<double>(unsigned seed)>& draw,
                                  std::size_t count);

} // namespace rigor::testing
