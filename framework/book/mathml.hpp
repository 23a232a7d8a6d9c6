// SPDX-License-Identifier: MIT
// Formulas as MathML, which browsers show without any script.
#pragma once

#include <string>

namespace rigor::book {

/// A formula in the commands of LaTeX that the handouts use, as an element <math>.
/// @param is_block  on lines of its own
/// @throws InputError for a command that is not known
std::string mathml(const std::string& latex, bool is_block);

/// A text with <, > and & replaced.
std::string escaped(const std::string& text);

} // namespace rigor::book
