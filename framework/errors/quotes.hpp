// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// A text in quotes, in one short line: quotes, control characters and bytes that are not UTF-8 are
/// escaped. An ellipsis replaces the characters that begin after the first 40 bytes; a character
/// that begins within them is shown whole.
std::string in_quotes(std::string_view text);

} // namespace rigor
