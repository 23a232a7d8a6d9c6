// SPDX-License-Identifier: MIT
// The bar that shows which value each color stands for.
#pragma once

#include "render/gl/gl.hpp"
#include "render/gl/shaders/program.hpp"
#include "render/picture.hpp"

#include <span>

namespace rigor {

/// The place of the bar on the screen [pixels].
struct BarPlace {
    float left = 0, right = 0, top = 0, bottom = 0;

    /// The y coordinate on the screen [pixels] of a place on the bar.
    /// @param place  0 at the low end, 1 at the high end
    float at(float place) const { return bottom + place * (top - bottom); }
};

/// The bar without its letters.
class ColorBar {
public:
    ColorBar();
    void draw(const ColorScale& scale, const BarPlace& place);

private:
    struct Corner {
        float x, y;
        Vector4f color; // sRGB-encoded
    };
    void add(float left, float top, float right, float bottom, const Vector4f& color);

    GlArrays arrays_;
    GlBuffer buffer_;
    Program program_;
    std::vector<Corner> corners_;
};

/// The sRGB encoding of linear light.
float encoded_light(float linear);

} // namespace rigor
