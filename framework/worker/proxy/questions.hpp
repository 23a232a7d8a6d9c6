// SPDX-License-Identifier: MIT
// Checks what a test that a student wrote (A8) answers: its judgement, or its question about the
// formula under test. The grader's own formulas answer the question, with its numbers as their
// arguments, so they are checked before.
#pragma once

#include "formulas/validation.hpp"

#include <cstddef>
#include <string_view>

namespace rigor {

/// What a question may be about.
struct Askable {
    std::size_t known = 0;     // number of calls whose results the test knows
    std::size_t arguments = 0; // number of numbers that the formula under test takes
};

/// Checks that a judgement names a line, and that a question is at most 1 MiB long, follows one of
/// the known calls, has as many numbers as the formula takes, and none beyond `largest_question`.
/// @param test  the name of the student's test, for messages
/// @throws std::out_of_range
void check_judgement(std::string_view test, const Judgement& judgement, const Askable& askable);

/// The largest magnitude of a number in a question. Tests need at most 1e9, times a change of units
/// by 2⁴⁰ to some power.
inline constexpr double largest_question = 1e100;

/// The same for the test of a formula whose arguments are plain values.
template <class Result, class... Argument>
void check_judgement(std::string_view test, const Judgement& judgement,
                     const UnderTest<Result, Argument...>& formula)
{
    check_judgement(test, judgement,
                    Askable{formula.known.size(), (sizeof(Argument) + ...) / sizeof(double)});
}

/// The same for `test_units`, whose formula takes as many numbers as its example has.
inline void check_judgement(std::string_view test, const Judgement& judgement,
                            const UnknownFormula& formula, const std::vector<double>& example,
                            const std::vector<Dimension>&, const std::vector<Dimension>&)
{
    check_judgement(test, judgement, Askable{formula.known.size(), example.size()});
}

} // namespace rigor
