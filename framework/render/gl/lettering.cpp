// SPDX-License-Identifier: MIT
// Draws the texts of a picture. Each letter is a rectangle that shows its part of the font's atlas,
// at whole pixels. Labels are centered above the projections of their points, and other texts are
// lines in the top left corner. The color bar gets its title above and its numbers to the right.
#include "render/gl/lettering.hpp"

#include "render/gl/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace rigor {
namespace {

// Number of letters of a line that are drawn. Longer lines are cut off.
constexpr std::size_t longest = 160;

/// The sRGB encoding of linear light, approximated by a power, which is enough for letters.
float encoded(float linear)
{
    return std::pow(std::clamp(linear, 0.0F, 1.0F), 1 / 2.2F);
}

} // namespace

Lettering::Lettering(int width, int height)
    : width_(width), height_(height), small_(small_letters(height)), large_(large_letters(height)),
      program_(Look::text, "")
{
    glBindTexture(GL_TEXTURE_2D, atlas_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, Font::side, Font::side, 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    for (const GLuint index : {0U, 1U}) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                              reinterpret_cast<const void*>(index * offsetof(Corner, color)));
    }
}

float Lettering::width_of(const Text& text, int size)
{
    float width = 0;
    for (const char32_t letter : letters(text.text).substr(0, longest))
        width += font_.glyph(letter, size).advance;
    return width;
}

void Lettering::add_line(const Text& text, int size, float x, float y)
{
    for (const char32_t letter : letters(text.text).substr(0, longest)) {
        const Glyph& glyph = font_.glyph(letter, size);
        // Letters are placed at whole pixels, with one more pixel on each side for the pale rim
        // around the letter.
        const auto place = [&](int u, int v) {
            Corner corner{std::round(x) + static_cast<float>(glyph.left - 1 + u),
                          std::round(y) + static_cast<float>(glyph.top - 1 + v),
                          static_cast<float>(glyph.x - 1 + u),
                          static_cast<float>(glyph.y - 1 + v),
                          {}};
            for (int i = 0; i < 3; ++i)
                corner.color[i] = encoded(text.color[i]);
            corner.color[3] = text.color[3];
            return corner;
        };
        if (glyph.width > 0) {
            const int w = glyph.width + 2, h = glyph.height + 2;
            corners_.insert(corners_.end(), {place(0, 0), place(w, 0), place(w, h), place(0, 0),
                                             place(w, h), place(0, h)});
        }
        x += glyph.advance;
    }
}

void Lettering::add_label(const Text& text, const View& view)
{
    const Eigen::Map<const Eigen::Matrix4f> to_clip(view.to_clip);
    const Vector4f p = to_clip * text.point->homogeneous();
    if (!(p.w() > 0) || !p.allFinite()) return; // behind the camera, or not finite
    const float x = (0.5F + 0.5F * p.x() / p.w()) * static_cast<float>(width_);
    const float y = (0.5F + 0.5F * p.y() / p.w()) * static_cast<float>(height_);
    if (!(std::abs(x) < 4.0F * static_cast<float>(width_)) ||
        !(std::abs(y) < 4.0F * static_cast<float>(height_)))
        return;
    const int size = size_of(text);
    add_line(text, size, x - width_of(text, size) / 2, y - 0.25F * static_cast<float>(size));
}

std::vector<Text> Lettering::wrapped(const Text& text, float width)
{
    std::vector<Text> lines;
    std::istringstream words(text.text);
    for (std::string word; words >> word;) {
        Text longer = text;
        longer.text = lines.empty() ? word : lines.back().text + " " + word;
        if (!lines.empty() && width_of(longer, small_) <= width) {
            lines.back() = longer;
        } else {
            lines.push_back(text);
            lines.back().text = word;
        }
    }
    return lines;
}

// Draws the color bar in its strip at the right border, with its numbers to the right and its title
// above.
void Lettering::draw_scale(const ColorScale& scale)
{
    const auto pixels = [](int n) { return static_cast<float>(n); };
    const auto label = [](const std::string& text) {
        return Text{text, Vector4f(0.022F, 0.033F, 0.055F, 1), false, {}};
    };
    const float step = 0.5F * pixels(small_);
    const float strip = pixels(color_bar_strip(width_, height_));
    const float left = std::round(pixels(width_) - strip + step);
    const BarPlace place{left, left + std::round(2 * step), std::round(0.28F * pixels(height_)),
                         std::round(0.74F * pixels(height_))};
    float y = place.top - 1.8F * step;
    const std::vector<Text> title = wrapped(label(scale.title), strip - 2 * step);
    for (auto line = title.rbegin(); line != title.rend(); ++line, y -= 2.6F * step)
        add_line(*line, small_, left, y);
    for (const ColorScale::Tick& tick : scale.ticks)
        add_line(label(tick.text), small_, place.right + 1.6F * step,
                 place.at(tick.place) + 0.7F * step);
    if (!bar_) bar_.emplace();
    bar_->draw(scale, place);
}

void Lettering::upload()
{
    glBindTexture(GL_TEXTURE_2D, atlas_);
    if (uploaded_ == font_.painted()) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, Font::side, Font::side, GL_RED, GL_UNSIGNED_BYTE,
                    font_.atlas().data());
    uploaded_ = font_.painted();
}

void Lettering::draw(const Picture& picture, const View& view)
{
    corners_.clear();
    const float margin = 0.8F * static_cast<float>(large_);
    float y = margin;
    for (const Text& text : picture.texts) {
        if (text.point) {
            add_label(text, view);
            continue;
        }
        const int size = size_of(text);
        add_line(text, size, margin, y + 0.8F * static_cast<float>(size));
        y += 1.3F * static_cast<float>(size);
    }
    if (picture.color_scale) draw_scale(*picture.color_scale);
    if (corners_.empty()) return;
    upload();
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)),
                 corners_.data(), GL_STREAM_DRAW);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
}

} // namespace rigor
