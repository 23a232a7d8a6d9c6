// SPDX-License-Identifier: MIT
// Decodes UTF-8 (RFC 3629): the first byte says how many bytes a character has. Overlong
// encodings, surrogates, and numbers above 0x10FFFF are not UTF-8.
#include "errors/utf8.hpp"

#include <cstdint>

namespace rigor {

namespace {

struct Range {
    std::uint32_t first, last;
};

// The control characters and the invisible characters: Unicode's category Cf (format) and its
// default-ignorable characters, such as the fillers of Hangul. Three kinds of them are left out:
// Arabic and Kaithi signs of category Cf, which are visible; U+200C and U+200D, which names in
// Persian and in Indian scripts need; U+FE00 to U+FE0F, which emoji need.
constexpr Range controls[] = {
    {0x00, 0x1F},       {0x7F, 0x9F},       {0xAD, 0xAD},       {0x034F, 0x034F},
    {0x061C, 0x061C},   {0x115F, 0x1160},   {0x17B4, 0x17B5},   {0x180B, 0x180F},
    {0x200B, 0x200B},   {0x200E, 0x200F},   {0x2028, 0x202E},   {0x2060, 0x206F},
    {0x3164, 0x3164},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},   {0xFFF0, 0xFFFB},
    {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}};

constexpr Range blanks[] = {{0x20, 0x20},     {0xA0, 0xA0},     {0x1680, 0x1680}, {0x2000, 0x200A},
                            {0x202F, 0x202F}, {0x205F, 0x205F}, {0x2800, 0x2800}, {0x3000, 0x3000}};

template <std::size_t n> bool is_in(const Range (&ranges)[n], std::uint32_t character)
{
    for (const auto& [first, last] : ranges)
        if (first <= character && character <= last) return true;
    return false;
}

struct Character {
    std::size_t size = 0; // [bytes], 0 if the bytes are not UTF-8
    std::uint32_t number = 0;
};

// The character at the start of a text that is not empty.
Character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if ((byte(0) >= 0x80 && byte(0) < 0xC2) || byte(0) > 0xF4 || text.size() < size) return {};
    constexpr std::uint32_t first_bits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    std::uint32_t character = byte(0) & first_bits[size];
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        character = character << 6 | (byte(i) & 0x3Fu);
    }
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
    if (character < smallest[size] || character > 0x10FFFF || is_surrogate) return {};
    return {size, character};
}

} // namespace

std::size_t character_size(std::string_view text)
{
    const Character first = first_character(text);
    return is_in(controls, first.number) ? 0 : first.size;
}

std::size_t blank_size(std::string_view text)
{
    if (text.empty()) return 0;
    const Character first = first_character(text);
    return is_in(blanks, first.number) ? first.size : 0;
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
