// SPDX-License-Identifier: MIT
#include "render/colors.hpp"

#include <array>

namespace rigor::colors {

/// Okabe and Ito (2008), "Color Universal Design": told apart by all common kinds of sight. A little
/// softer here, since large surfaces glare.
Vector4f palette(std::size_t n)
{
    static constexpr std::array<std::array<double, 3>, 7> colors = {{{0.16, 0.47, 0.71},
                                                                     {0.91, 0.55, 0.13},
                                                                     {0.13, 0.60, 0.49},
                                                                     {0.80, 0.34, 0.20},
                                                                     {0.46, 0.72, 0.88},
                                                                     {0.76, 0.50, 0.66},
                                                                     {0.91, 0.78, 0.31}}};
    const auto& c = colors[n % colors.size()];
    return linear_color(c[0], c[1], c[2]);
}

const Vector4f resting = linear_color(0.66, 0.68, 0.71);
const Vector4f dark = linear_color(0.16, 0.20, 0.26);
const Vector4f ghostly = linear_color(0.42, 0.30, 0.62, 0.34);

// Overlays: the opacity is what is left of it behind a body.
const Vector4f difference = linear_color(0.86, 0.10, 0.42, 0.75);
const Vector4f axis_x = linear_color(0.83, 0.20, 0.18, 0.22);
const Vector4f axis_y = linear_color(0.15, 0.60, 0.25, 0.22);
const Vector4f axis_z = linear_color(0.13, 0.36, 0.80, 0.22);
const Vector4f angular_velocity = linear_color(0.56, 0.20, 0.68, 0.22);
const Vector4f angular_momentum = linear_color(0.92, 0.52, 0.05, 0.22);
const Vector4f impulse = linear_color(0.86, 0.10, 0.42, 0.22);
const Vector4f touching = linear_color(0.16, 0.20, 0.26, 0.22);

} // namespace rigor::colors
