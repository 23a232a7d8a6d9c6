// SPDX-License-Identifier: MIT
#include "errors/quotes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

// Size of the UTF-8 character at the start of a text [bytes]; 0 if it is not UTF-8 or is a control
// character.
std::size_t character_size(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if (byte(0) < 0x20 || byte(0) == 0x7F || (byte(0) >= 0x80 && byte(0) < 0xC2)) return 0;
    if (byte(0) > 0xF4 || text.size() < size) return 0;
    if (byte(0) == 0xC2 && byte(1) < 0xA0) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    return size;
}

} // namespace

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string shown = "\"";
    for (std::size_t i = 0; i < text.size();) {
        if (i >= longest) return shown + "…\"";
        const std::size_t size = character_size(text.substr(i));
        if (text[i] == '\n')
            shown += "\\n";
        else if (text[i] == '"')
            shown += "\\\"";
        else if (size == 0)
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
        else
            shown += text.substr(i, size);
        i += std::max<std::size_t>(size, 1);
    }
    return shown + "\"";
}

} // namespace rigor
