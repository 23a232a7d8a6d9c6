// SPDX-License-Identifier: MIT
#include "render/gl/target.hpp"

#include "render/gl/light.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace rigor {
namespace {

void storage(GLuint name, GLenum format, int samples, int width, int height, GLenum attachment)
{
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
}

void require_complete(const char* what)
{
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR)
        throw std::runtime_error(std::string("OpenGL has no memory for ") + what);
}

} // namespace

Target::Target(int width, int height) : width_(width), height_(height)
{
    constexpr int samples = 4; // per pixel; more would smooth edges better but take more time
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    storage(resolved_color_, GL_SRGB8_ALPHA8, 0, width, height, GL_COLOR_ATTACHMENT0);
    require_complete("the picture");
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    storage(sampled_color_, GL_SRGB8_ALPHA8, samples, width, height, GL_COLOR_ATTACHMENT0);
    storage(sampled_depth_, GL_DEPTH_COMPONENT24, samples, width, height, GL_DEPTH_ATTACHMENT);
    require_complete("four samples a pixel");
}

void Target::start() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    glViewport(0, 0, width_, height_);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Target::resolve() const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

Image Target::read() const
{
    Image image{width_, height_, {}};
    image.rgba.resize(4UL * width_ * height_);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL failed to draw the picture");
    return image;
}

ShadowMap::ShadowMap()
{
    glBindTexture(GL_TEXTURE_2D, depth_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, shadow_side, shadow_side, 0,
                 GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array<float, 4> lit = {1, 1, 1, 1}; // no shadows outside the map
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    require_complete("the shadow map");
}

void ShadowMap::start() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, shadow_side, shadow_side);
    glClear(GL_DEPTH_BUFFER_BIT);
}

} // namespace rigor
