// SPDX-License-Identifier: MIT
// Compiled shaders and the data that they share.
#pragma once

#include "render/gl/gl.hpp"
#include "render/gl/shaders/look.hpp"

#include <string>

namespace rigor {

/// The data that the shaders of one picture share, in the layout of their uniform block (std140).
struct View {
    float to_clip[16], to_light[16]; // 4 × 4 matrices, by columns
    float eye[4];
    float light[4];  // unit vector to the sun; light[3] is the offset of shadows along a normal [m]
    float screen[4]; // width, height [pixels], 1 / side of the shadow map [1/pixels], unused
};

/// The compiled shaders of a look. `definitions` are whole lines for the preprocessor, such as
/// "#define GHOST\n", which are put before the source. They define some of these names:
/// - SHADOWS: there is a shadow map.
/// - GHOST: the body is translucent, with visible edges.
/// - CONTRAST: how far the two tones of octants differ, a number that `Look::model` needs.
/// - TINT: `smooth`, which interpolates the colors of the corners; `flat` if it is not defined.
/// - THROUGH: an overlay is drawn where a body hides it, in one flat color.
/// @throws std::runtime_error with the compiler's messages
class Program {
public:
    Program(Look look, const std::string& definitions);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { glDeleteProgram(program_); }

    void use() const { glUseProgram(program_); }
    GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }

private:
    GLuint program_;
};

} // namespace rigor
