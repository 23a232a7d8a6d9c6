// SPDX-License-Identifier: MIT
// Forms of the formulas of A8 that the seed draws. The law of a formula leaves something open: the
// last digits of its results, the direction of a tangent, the method of a step, a constant factor
// without a unit. If this were the same in each run, a test could learn how a right formula fills
// it, and would need no law. So here it is drawn anew for each run.
#pragma once

#include "numeric_formula.hpp"

#include <vector>

namespace rigor::testing {

/// The formula with other last digits: each number in its results is changed by a share of itself,
/// 2e-14 or less. Arguments that differ by powers of two only have the same change, so that units
/// which are powers of two still change no digit.
NumericFormula with_drawn_digits(const NumericFormula& formula, unsigned seed);

/// The formula with each number in its results times a drawn factor from 1 to 2. If the formula
/// keeps the law of the units, so does this one.
NumericFormula with_drawn_factors(const NumericFormula& formula, unsigned seed);

/// Tangents t of n that are turned about n by an angle which depends on n smoothly. They are as
/// right, or as wrong, as those of the formula.
NumericFormula in_drawn_directions(const NumericFormula& tangent, unsigned seed);
std::vector<WrongNumeric> in_drawn_directions(std::vector<WrongNumeric> tangents);

/// Right formulas of each task: those of the candidates; one whose rounding errors are nearly as
/// large as A8 allows; and for a step of an oscillator also weighted means of two methods.
std::vector<NumericFormula> right_collisions();
std::vector<NumericFormula> right_springs();
std::vector<NumericFormula> right_tangents();
std::vector<NumericFormula> right_steps();

} // namespace rigor::testing
