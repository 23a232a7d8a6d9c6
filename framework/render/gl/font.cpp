// SPDX-License-Identifier: MIT
#include "render/gl/font.hpp"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rigor {

Font::Font() : atlas_(static_cast<std::size_t>(side) * side)
{
    std::ifstream in(RIGOR_FONT, std::ios::binary);
    file_.assign(std::istreambuf_iterator<char>(in), {});
    if (file_.empty())
        throw std::runtime_error("no font for labels at " RIGOR_FONT
                                 ": install the package fonts-dejavu-core");
}

const Glyph& Font::glyph(char32_t letter, int size)
{
    const auto key = std::pair(letter, size);
    const auto known = glyphs_.find(key);
    return known != glyphs_.end() ? known->second
                                  : glyphs_.emplace(key, paint(letter, size)).first->second;
}

Glyph Font::paint(char32_t letter, int size)
{
    stbtt_fontinfo font;
    if (!stbtt_InitFont(&font, file_.data(), stbtt_GetFontOffsetForIndex(file_.data(), 0)))
        throw std::runtime_error(RIGOR_FONT " is not a TrueType font");
    const float scale = stbtt_ScaleForPixelHeight(&font, static_cast<float>(size));
    const int index = stbtt_FindGlyphIndex(&font, static_cast<int>(letter));
    int advance = 0, x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphHMetrics(&font, index, &advance, nullptr);
    stbtt_GetGlyphBitmapBox(&font, index, scale, scale, &x0, &y0, &x1, &y1);
    Glyph glyph{0, 0, x1 - x0, y1 - y0, x0, y0, scale * static_cast<float>(advance)};

    // The distance between letters in the atlas; 2 would do. The shader reads two pixels beyond a
    // letter: the rim is one pixel wide, and each of its pixels depends on its neighbors.
    constexpr int gap = 3; // [pixels]
    if (row_x_ + glyph.width + gap > side) {
        row_y_ += row_height_ + gap;
        row_x_ = 1;
        row_height_ = 0;
    }
    if (row_y_ + glyph.height + gap > side || glyph.width + gap > side)
        return {0, 0, 0, 0, 0, 0, glyph.advance}; // no room in the atlas: the text has a gap
    glyph.x = row_x_ + 1;
    glyph.y = row_y_ + 1;
    row_x_ += glyph.width + gap;
    row_height_ = std::max(row_height_, glyph.height);
    stbtt_MakeGlyphBitmap(&font, atlas_.data() + static_cast<std::size_t>(glyph.y) * side + glyph.x,
                          glyph.width, glyph.height, side, scale, scale, index);
    return glyph;
}

std::u32string letters(std::string_view text)
{
    constexpr char32_t unknown = 0xFFFD;
    std::u32string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        if (first < 0x80) {
            result += first < 0x20 ? U' ' : char32_t{first};
            continue;
        }
        const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
        char32_t letter = more ? first & (0x3F >> more) : unknown;
        for (int k = 0; k < more; ++k) {
            if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) {
                letter = unknown;
                break;
            }
            letter = letter << 6 | (static_cast<unsigned char>(text[i++]) & 0x3F);
        }
        result += letter <= 0x10FFFF ? letter : unknown;
    }
    return result;
}

} // namespace rigor
