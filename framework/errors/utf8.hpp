// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace rigor {

/// Size of the UTF-8 character at the start of a text that is not empty [bytes]. It is 0 if the
/// bytes are not UTF-8, or if they are a control character, such as one that moves the cursor,
/// breaks the line, or reverses the direction of the text around it.
std::size_t character_size(std::string_view text);

/// Whether a text is UTF-8 without control characters.
bool is_plain_utf8(std::string_view text);

} // namespace rigor
