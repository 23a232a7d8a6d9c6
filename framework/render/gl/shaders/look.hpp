// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rigor {

/// The kinds of objects to draw. Each kind has shaders of its own.
enum class Look { box, ball, model, overlay, ground, background, shadow, text, patch, count };

/// The shaders of a look, in OpenGL's shading language.
struct ShaderSource {
    std::string vertex, fragment;
};

} // namespace rigor
