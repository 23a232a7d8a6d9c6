// SPDX-License-Identifier: MIT
// Wrong formulas of A8 that a program makes of a right one.
#pragma once

#include "numeric_formula.hpp"

#include <functional>
#include <vector>

namespace rigor::testing {

/// A number of the result is scaled, has the other sign, is that of the call before, or is wrong
/// beyond a threshold; an argument is ignored, or two are exchanged. Each differs clearly from the
/// right formula for a quarter of the arguments that `draw` gives, or more.
std::vector<WrongNumeric> mutants(const NumericFormula& formula,
                                  const std::function<std::vector<double>(unsigned seed)>& draw,
                                  std::size_t count);

} // namespace rigor::testing
