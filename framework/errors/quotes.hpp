// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// A text in quotes, in one short line: control characters are escaped, and what follows the first
/// 40 bytes is cut off.
std::string in_quotes(std::string_view text);

} // namespace rigor
