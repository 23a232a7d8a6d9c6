// SPDX-License-Identifier: MIT
// The framebuffers: one with four samples for each pixel of the picture, one to which these are
// resolved (one sample for each pixel) and from which the image is read, and one with the shadow
// map.
#pragma once

#include "render/gl/gl.hpp"
#include "render/image.hpp"

namespace rigor {

class Target {
public:
    /// @throws std::runtime_error if there is no memory for the framebuffers
    Target(int width, int height);

    void start() const;   // clears; from now on, drawing has four samples for each pixel
    void resolve() const; // averages the samples; from now on, colors have to be sRGB-encoded
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
