// SPDX-License-Identifier: MIT
// What is drawn in which color.
#pragma once

#include "render/picture.hpp"

#include <cstddef>

namespace rigor::colors {

/// Of the n-th moving body.
Vector4f palette(std::size_t n);

/// Of a quantity from 0 to 1: from dark blue over red to pale yellow, in steps that look alike.
/// Since it grows lighter all the way, it is read without telling hues apart.
Vector4f scale(double value);

extern const Vector4f crack;      // what a crack opened
extern const Vector4f pale_crack; // the same among colors of the scale
extern const Vector4f resting;    // static bodies
extern const Vector4f dark;       // letters
extern const Vector4f ghostly, difference;
extern const Vector4f axis_x, axis_y, axis_z, angular_velocity, angular_momentum, impulse, touching;

/// Letters are never faint.
inline Vector4f opaque(const Vector4f& color)
{
    return {color.x(), color.y(), color.z(), 1};
}

} // namespace rigor::colors
