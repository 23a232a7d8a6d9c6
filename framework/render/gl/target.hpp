// SPDX-License-Identifier: MIT
// What is drawn into: four samples a pixel, resolved to one, read back; and the sun's depth map.
#pragma once

#include "render/gl/gl.hpp"
#include "render/image.hpp"

namespace rigor {

class Target {
public:
    /// @throws std::runtime_error if there is no memory for it
    Target(int width, int height);

    void start() const;   // what follows is drawn with four samples
    void resolve() const; // what follows is drawn on the resolved pixels, as they are encoded
    Image read() const;

private:
    int width_, height_;
    GlFramebuffer sampled_, resolved_;
    GlRenderbuffer sampled_color_, sampled_depth_, resolved_color_;
};

class ShadowMap {
public:
    ShadowMap();
    void start() const;
    void bind() const { glBindTexture(GL_TEXTURE_2D, depth_); }

private:
    GlFramebuffer framebuffer_;
    GlTexture depth_;
};

} // namespace rigor
