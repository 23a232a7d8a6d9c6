// SPDX-License-Identifier: MIT
// Colour and width, where the reader is a person at a terminal.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

enum class Color { none, bold, dim, green, yellow, red };

/// Whether this descriptor is a terminal.
bool is_terminal(int descriptor);

/// Whether to colour what goes to this descriptor: it is a terminal, NO_COLOR is not set, TERM is
/// not "dumb".
bool wants_color(int descriptor);

/// The text in a colour, or as it is.
std::string colored(std::string_view text, Color color, bool wanted);

/// Columns that a UTF-8 text takes; every character counts one.
std::size_t columns(std::string_view text);

/// The text, and spaces up to a width.
std::string padded(std::string_view text, std::size_t width);

/// The text broken at spaces into lines of at most `width` columns; lines after the first begin
/// with `indent` spaces. A word that is too long stays whole. Line breaks in it are kept.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

} // namespace rigor
