// SPDX-License-Identifier: MIT
// The looks of things, in OpenGL's shading language.
#pragma once

#include "render/gl/gl.hpp"
#include "render/gl/shaders/look.hpp"

#include <string>

namespace rigor {

/// What one picture's shaders share, in the layout of their uniform block (std140).
struct View {
    float to_clip[16], to_light[16]; // by columns
    float eye[4];
    float light[4];  // towards it; [3]: the shadow's offset along a normal [m]
    float screen[4]; // width, height [pixels], 1 / side of the shadow map
};

/// A compiled look. `definitions` are names its source asks for: SHADOWS, GHOST, CONTRAST, THROUGH.
/// @throws std::runtime_error with the compiler's words
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
