// SPDX-License-Identifier: MIT
// Implementations of a formula, right and wrong ones, on which a student's test is tried.
#pragma once

#include "formulas/validation.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigor::testing {

/// The function behind a formula under test.
template <class Formula> struct FunctionOf;
template <class Result, class... Argument> struct FunctionOf<UnderTest<Result, Argument...>> {
    using type = std::function<Result(Argument...)>;
};
template <class Formula> using Function = typename FunctionOf<Formula>::type;

/// A wrong implementation.
template <class Formula> struct WrongFormula {
    std::string clue; // says when it is wrong, for a student whose test accepts it
    Function<Formula> formula;
};

/// A formula with its implementations.
template <class Formula> struct Candidates {
    using Wrong = std::vector<WrongFormula<Formula>>;
    std::vector<Function<Formula>> right; // all of them are right, and all are written differently
    Wrong ordinary;                       // wrong for nearly all arguments
    Wrong special;                        // wrong for some arguments only
};

/// A formula on numbers whose dimensions are known.
struct FormulaWithUnits {
    std::string clue; // empty for a right formula
    Function<UnknownFormula> formula;
    std::vector<double> example;
    std::vector<Dimension> arguments, result;
    /// For a wrong formula, a right one with the same example and dimensions. Without it, a test
    /// could know a wrong formula by these, and would not have to call it.
    Function<UnknownFormula> right = nullptr;
};

const Candidates<LineCollision>& line_collisions();
const Candidates<SpringForce>& spring_forces();
const Candidates<Tangent>& tangents();
const Candidates<OscillatorStep>& oscillator_steps();

/// Right formulas, like those of other topics, with dimensions.
const std::vector<FormulaWithUnits>& right_units();
/// Wrong formulas with a wrong power of a unit, or with a constant that has a unit.
const std::vector<FormulaWithUnits>& wrong_powers();
/// Wrong formulas in which a threshold, a limit or a small number has a unit.
const std::vector<FormulaWithUnits>& wrong_thresholds();

} // namespace rigor::testing
