// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace rigor {

/// Size of the UTF-8 character at the start of a text that is not empty [bytes]. It is 0 if the
/// bytes are not UTF-8, or if they are a control character, such as one that moves the cursor,
/// breaks the line, or reverses the direction of the text around it, or a character that cannot be
/// seen, with which two names look the same.
std::size_t character_size(std::string_view text);

/// Size of the blank at the start of a text [bytes]: of a space of any width, also of one that does
/// not break. It is 0 if the text begins with none.
std::size_t blank_size(std::string_view text);

/// Whether a text is UTF-8 without control characters and without characters that cannot be seen.
bool is_plain_utf8(std::string_view text);

} // namespace rigor
