// SPDX-License-Identifier: MIT
// The texts of a picture, drawn on the finished picture.
#pragma once

#include "render/gl/color_bar.hpp"
#include "render/gl/font.hpp"
#include "render/gl/gl.hpp"
#include "render/gl/shaders/program.hpp"
#include "render/picture.hpp"

#include <optional>
#include <vector>

namespace rigor {

class Lettering {
public:
    Lettering(int width, int height);
    void draw(const Picture& picture, const View& view);

private:
    struct Corner { // a corner of a letter's rectangle
        float x, y, u, v;
        float color[4];
    };
    void add_line(const Text& text, int size, float x, float y);
    void add_label(const Text& text, const View& view);
    // Divides a text into lines of at most this width [pixels], unless a word is wider.
    std::vector<Text> wrapped(const Text& text, float width);
    void draw_scale(const ColorScale& scale);
    float width_of(const Text& text, int size);
    int size_of(const Text& text) const { return text.large ? large_ : small_; }
    void upload();

    int width_, height_;
    int small_, large_; // heights of letters [pixels]
    Font font_;
    std::size_t uploaded_ = 0;
    Program program_;
    GlTexture atlas_;
    GlArrays arrays_;
    GlBuffer buffer_;
    std::vector<Corner> corners_;
    std::optional<ColorBar> bar_;
};

} // namespace rigor
