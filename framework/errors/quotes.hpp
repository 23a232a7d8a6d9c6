// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rigor {

/// A text in quotes, in one short line: quotes, control characters, characters that cannot be seen
/// and bytes that are not UTF-8 are escaped. An ellipsis replaces the characters that begin after
/// the first `longest` bytes; a character that begins within them is shown whole.
std::string in_quotes(std::string_view text, std::size_t longest = 40);

/// A text of somebody else, such as the message that a student's code has thrown, with a bar before
/// each line, so that none of its lines looks like a line of ours. It ends without a line break.
std::string behind_bars(std::string_view text);

} // namespace rigor
