// SPDX-License-Identifier: MIT
// Formulas as MathML, which browsers show without any script.
#pragma once

#include <string>

namespace rigor::book {

/// Converts a LaTeX formula to an element <math>. It knows the commands that the handouts use.
/// @param is_block  whether the formula stands on a line of its own
/// @throws InputError for a formula that it cannot read, such as one with an unknown command
std::string mathml(const std::string& latex, bool is_block);

} // namespace rigor::book
