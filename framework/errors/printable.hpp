// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rigor {

/// Text from outside made safe for a terminal and for JSON: each byte but ASCII characters, line
/// breaks and tabs becomes a question mark, so that no control character of any kind is left.
std::string printable(std::string text);

} // namespace rigor
