// SPDX-License-Identifier: MIT
// OpenGL 3.3 core. No loader of its functions is needed: the library that a drawing module links
// (renderer.hpp), libOSMesa or libOpenGL, exports them.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <utility>

namespace rigor {

/// Owns one OpenGL name, such as that of a buffer.
template <auto& Generate, auto& Delete> class GlName {
public:
    GlName() { Generate(1, &name_); }
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    GlName(const GlName&) = delete;
    GlName& operator=(const GlName&) = delete;
    ~GlName()
    {
        if (name_) Delete(1, &name_);
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

using GlBuffer = GlName<glGenBuffers, glDeleteBuffers>;
using GlArrays = GlName<glGenVertexArrays, glDeleteVertexArrays>;
using GlTexture = GlName<glGenTextures, glDeleteTextures>;
using GlFramebuffer = GlName<glGenFramebuffers, glDeleteFramebuffers>;
using GlRenderbuffer = GlName<glGenRenderbuffers, glDeleteRenderbuffers>;

} // namespace rigor
