// SPDX-License-Identifier: MIT
#include "render/gl/color_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rigor {

float encoded_light(float linear)
{
    const float c = std::clamp(linear, 0.0F, 1.0F);
    return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
}

ColorBar::ColorBar() : program_(Look::patch, "")
{
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                          reinterpret_cast<const void*>(offsetof(Corner, color)));
}

void ColorBar::add(float left, float top, float right, float bottom, const Vector4f& color)
{
    Vector4f ink(0, 0, 0, color[3]);
    for (int i = 0; i < 3; ++i)
        ink[i] = encoded_light(color[i]);
    corners_.insert(corners_.end(), {{left, top, ink},
                                     {right, top, ink},
                                     {right, bottom, ink},
                                     {left, top, ink},
                                     {right, bottom, ink},
                                     {left, bottom, ink}});
}

void ColorBar::draw(const ColorScale& scale, const BarPlace& place)
{
    if (scale.colors.empty()) return;
    corners_.clear();
    const Vector4f frame(0.022F, 0.033F, 0.055F, 1);
    add(place.left - 1, place.top - 1, place.right + 1, place.bottom + 1, frame);
    const auto steps = static_cast<float>(scale.colors.size());
    for (std::size_t i = 0; i < scale.colors.size(); ++i) {
        const auto n = static_cast<float>(i);
        add(place.left, std::round(place.at((n + 1) / steps)), place.right,
            std::round(place.at(n / steps)), scale.colors[i]);
    }
    const float length = 0.4F * (place.right - place.left);
    for (const ColorScale::Tick& tick : scale.ticks) {
        const float y = std::round(place.at(tick.place));
        add(place.right, y - 0.5F, place.right + length, y + 0.5F, frame);
    }
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)),
                 corners_.data(), GL_STREAM_DRAW);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
}

} // namespace rigor
