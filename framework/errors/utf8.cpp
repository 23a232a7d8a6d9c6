// SPDX-License-Identifier: MIT
// Decodes UTF-8 (RFC 3629): the first byte says how many bytes a character has. Overlong
// encodings, surrogates, and numbers above 0x10FFFF are not UTF-8.
#include "errors/utf8.hpp"

#include <cstdint>

namespace rigor {

namespace {

bool is_control(std::uint32_t character)
{
    const auto is_between = [&](std::uint32_t first, std::uint32_t last) {
        return first <= character && character <= last;
    };
    return character < 0x20 || is_between(0x7F, 0x9F) || is_between(0x2028, 0x202E) ||
           is_between(0x2066, 0x2069);
}

} // namespace

std::size_t character_size(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if ((byte(0) >= 0x80 && byte(0) < 0xC2) || byte(0) > 0xF4 || text.size() < size) return 0;
    constexpr std::uint32_t first_bits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    std::uint32_t character = byte(0) & first_bits[size];
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
        character = character << 6 | (byte(i) & 0x3Fu);
    }
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
    if (character < smallest[size] || character > 0x10FFFF || is_surrogate) return 0;
    return is_control(character) ? 0 : size;
}

bool is_plain_utf8(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        if (size == 0) return false;
        text.remove_prefix(size);
    }
    return true;
}

} // namespace rigor
