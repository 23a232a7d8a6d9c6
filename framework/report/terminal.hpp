// SPDX-License-Identifier: MIT
// Colors and widths for text that a person reads on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

enum class Color { none, bold, dim, green, yellow, red };

/// Whether this descriptor is a terminal.
bool is_terminal(int descriptor);

/// Whether output to this descriptor is colored: if it is a terminal, NO_COLOR is empty or not set,
/// and TERM is set to anything but "dumb".
bool wants_color(int descriptor);

/// The text in a color, or unchanged if no color is wanted.
std::string colored(std::string_view text, Color color, bool wanted);

/// The columns that a UTF-8 text takes. Every character counts as one.
std::size_t columns(std::string_view text);

/// The text, padded with spaces to a width.
std::string padded(std::string_view text, std::size_t width);

/// The text broken at spaces into lines of at most `width` columns; lines after the first begin
/// with `indent` spaces. A word that is too long is not broken. Line breaks in the text are kept.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

} // namespace rigor
