// SPDX-License-Identifier: MIT
// Letters as pixels. Each one is painted into an atlas when it is first needed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor {

struct Glyph {
    int x = 0, y = 0, width = 0, height = 0; // in the atlas [pixels]
    // The upper left corner, relative to the pen on the base line, y down [pixels].
    int left = 0, top = 0;
    float advance = 0; // how far the pen moves [pixels]
};

class Font {
public:
    static constexpr int side = 1024; // side of the square atlas [pixels]

    /// @throws std::runtime_error if the font's file cannot be read
    Font();
    const Glyph& glyph(char32_t letter, int size);

    /// The atlas: coverage 0 … 255, `side` × `side`. It changes when a new glyph is requested.
    const std::vector<std::uint8_t>& atlas() const { return atlas_; }
    std::size_t painted() const { return glyphs_.size(); }

private:
    Glyph paint(char32_t letter, int size);

    std::vector<unsigned char> file_;
    std::vector<std::uint8_t> atlas_;
    std::map<std::pair<char32_t, int>, Glyph> glyphs_;
    // Where the next glyph is painted, and the height of the row of glyphs there [pixels].
    int row_x_ = 1, row_y_ = 1, row_height_ = 0;
};

/// The letters of a UTF-8 text. Bytes that are not UTF-8 become U+FFFD, and control characters
/// become spaces.
std::u32string letters(std::string_view text);

} // namespace rigor
