// SPDX-License-Identifier: MIT
// Tokens and numbers in the text of a mesh.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace rigor {

/// A token as an error message shows it: cut off after 24 characters, and with `?` for all but
/// printable ASCII characters.
/// @param end  words to show for an empty token, which stands for the end of a line or text
std::string quoted(std::string_view token, const char* end);

/// Reads the whole token as a number, which may begin with a plus sign. Returns whether the token
/// is such a number.
template <class Number> bool parse(std::string_view token, Number& number)
{
    // std::from_chars takes a minus, but no plus.
    if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
    return error == std::errc() && end == token.data() + token.size();
}

/// Appends a number in the fewest digits that read back as the same bits.
void append(std::string& text, double number);

} // namespace rigor
