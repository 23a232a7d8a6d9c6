// SPDX-License-Identifier: MIT
// The colors of bodies, of overlays and of color scales. The scale follows a path through the Oklab
// space of Ottosson (2020), in which distances are differences as the eye sees them. The path is
// cut into steps of equal length, so that equal differences of a value look equal.
#include "render/colors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigor::colors {

namespace {

using Eigen::Vector3d;

constexpr int steps = 256; // with fewer steps, one would see bands of color

// Linear sRGB of an Oklab color: lightness and two axes of color. Distances in this space are
// differences as the eye sees them. Ottosson (2020), "A perceptual color space for image
// processing" (Oklab).
Vector3d linear_of_oklab(const Vector3d& lab)
{
    Eigen::Matrix3d to_cones, to_rgb;
    to_cones << 1, 0.3963377774, 0.2158037573, 1, -0.1055613458, -0.0638541728, 1, -0.0894841775,
        -1.2914855480;
    to_rgb << 4.0767416621, -3.3077115913, 0.2309699292, -1.2684380046, 2.6097574011, -0.3413193965,
        -0.0041960863, -0.7034186147, 1.7076147010;
    const Vector3d cones = (to_cones * lab).array().cube();
    return to_rgb * cones;
}

// A path through Oklab, t from 0 to 1. Its lightness always grows, and its hue goes from blue over
// purple and red to yellow.
Vector3d on_path(double t)
{
    const double hue = (268 + 195 * t) * std::numbers::pi / 180;
    const double chroma = 0.165 - 0.03 * t;
    return {0.44 + 0.48 * t, chroma * std::cos(hue), chroma * std::sin(hue)};
}

// Colors at equal distances along the path.
std::array<Vector4f, steps + 1> even_colors()
{
    constexpr int fine = 4096; // pieces in which the path is measured, 16 for each of the `steps`
    std::array<double, fine + 1> length{};
    for (int i = 1; i <= fine; ++i)
        length[i] = length[i - 1] + (on_path(static_cast<double>(i) / fine) -
                                     on_path(static_cast<double>(i - 1) / fine))
                                        .norm();
    std::array<Vector4f, steps + 1> colors;
    for (int i = 0; i <= steps; ++i) {
        const double wanted = length[fine] * i / steps;
        const auto at = std::lower_bound(length.begin(), length.end(), wanted) - length.begin();
        const Vector3d rgb = linear_of_oklab(on_path(static_cast<double>(at) / fine));
        colors[i] << rgb.cwiseMax(0).cwiseMin(1).cast<float>(), 1;
    }
    return colors;
}

} // namespace

Vector4f scale(double value)
{
    static const std::array<Vector4f, steps + 1> colors = even_colors();
    return colors[std::lround(std::clamp(value, 0.0, 1.0) * steps)];
}

/// Okabe and Ito (2008), "Color Universal Design": colors that people with any common kind of color
/// vision can tell apart. The colors here are a little softer than in that paper, since large
/// surfaces in bright colors glare.
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

const Vector4f crack = linear_color(0.30, 0.12, 0.10);
const Vector4f pale_crack = linear_color(0.80, 0.82, 0.84);
const Vector4f resting = linear_color(0.66, 0.68, 0.71);
const Vector4f dark = linear_color(0.16, 0.20, 0.26);
const Vector4f ghostly = linear_color(0.42, 0.30, 0.62, 0.34);

// The colors of overlays. The opacity is used only where a body hides the overlay.
const Vector4f difference = linear_color(0.86, 0.10, 0.42, 0.75);
const Vector4f axis_x = linear_color(0.83, 0.20, 0.18, 0.22);
const Vector4f axis_y = linear_color(0.15, 0.60, 0.25, 0.22);
const Vector4f axis_z = linear_color(0.13, 0.36, 0.80, 0.22);
const Vector4f angular_velocity = linear_color(0.56, 0.20, 0.68, 0.22);
const Vector4f angular_momentum = linear_color(0.92, 0.52, 0.05, 0.22);
const Vector4f impulse = linear_color(0.86, 0.10, 0.42, 0.22);
const Vector4f touching = linear_color(0.16, 0.20, 0.26, 0.22);

} // namespace rigor::colors
