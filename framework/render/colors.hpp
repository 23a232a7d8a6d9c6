// SPDX-License-Identifier: MIT
// The colors of everything that is drawn.
#pragma once

#include "render/picture.hpp"

#include <cstddef>

namespace rigor::colors {

/// The color of moving body n, counted from 0. After seven colors they repeat.
Vector4f palette(std::size_t n);

/// The color of a quantity from 0 to 1: from dark blue through red to pale yellow, in steps that
/// look equal. Since its lightness always grows, it can be read without color vision.
Vector4f scale(double value);

extern const Vector4f crack;               // surfaces that a crack opened
extern const Vector4f pale_crack;          // such surfaces in pictures with a color scale
extern const Vector4f resting;             // static bodies
extern const Vector4f dark;                // letters
extern const Vector4f ghostly, difference; // bodies of a second run; marks of differences
extern const Vector4f axis_x, axis_y, axis_z, angular_velocity, angular_momentum, impulse, touching;

/// The same color without transparency, for letters.
inline Vector4f opaque(const Vector4f& color)
{
    return {color.x(), color.y(), color.z(), 1};
}

} // namespace rigor::colors
