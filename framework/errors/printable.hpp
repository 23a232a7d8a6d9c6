// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rigor {

/// Makes a text from another program safe for a terminal and for JSON. Each byte that is not a
/// printable ASCII character, a line break or a tab becomes a question mark, so that no other
/// control character is left.
std::string printable(std::string text);

} // namespace rigor
