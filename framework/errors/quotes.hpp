// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// A text in quotes, in one short line: quotes, control characters and bytes that are not UTF-8 are
/// escaped, and an ellipsis replaces what follows the first 40 bytes.
std::string in_quotes(std::string_view text);

} // namespace rigor
