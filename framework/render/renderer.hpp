// SPDX-License-Identifier: MIT
// Drawing off screen. OpenGL lives in modules that are loaded when the first picture is drawn, so
// that a command which draws nothing does not wait for it (27 ms of a process's start).
#pragma once

#include "render/image.hpp"
#include "render/picture.hpp"

#include <memory>
#include <string>

namespace rigor {

/// Draws pictures of one size. The same picture gives the same bits, whatever was drawn before and
/// however many threads draw. Use it from one thread; several renderers may live side by side.
class Renderer {
public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    virtual ~Renderer() = default;

    virtual Image draw(const Picture& picture) = 0;

    /// What draws, such as "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits)".
    virtual std::string name() const = 0;
};

/// How a context is made: OSMesa always draws with the processor; EGL without a surface takes a
/// graphics card where there is one.
enum class Gl { osmesa, egl };

/// The choice made when configuring, RIGOR_GL.
Gl default_gl();

/// @param text  "osmesa" or "egl"
/// @throws InputError for another
Gl gl_from_text(const std::string& text);

struct OpenRenderer {
    std::unique_ptr<Renderer> renderer;
    std::string notice; // one line to show if the other way had to be taken, else empty
};

/// A renderer of this size [pixels], by `gl` or, where that cannot be loaded, by the other.
/// @throws InputError for a size that cannot be, std::runtime_error if neither way works
OpenRenderer open_renderer(int width, int height, Gl gl = default_gl());

/// @throws InputError unless a picture of this size can be drawn
void check_size(int width, int height);

} // namespace rigor
