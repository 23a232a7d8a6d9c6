// SPDX-License-Identifier: MIT
// Drawing off screen. OpenGL is in modules that are loaded when the first renderer is made. So a
// command that draws nothing does not spend 27 ms of its start on loading OpenGL.
#pragma once

#include "render/image.hpp"
#include "render/picture.hpp"

#include <memory>
#include <string>

namespace rigor {

/// Draws pictures of one size. The same picture gives the same bits, whatever was drawn before and
/// however many threads draw. Each thread that draws needs a renderer of its own, since an OpenGL
/// context belongs to one thread.
class Renderer {
public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    virtual ~Renderer() = default;

    virtual Image draw(const Picture& picture) = 0;

    /// The name of the software that draws, such as "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits)".
    virtual std::string name() const = 0;
};

/// The library that makes the OpenGL context. OSMesa always draws with the processor; EGL without a
/// surface uses a graphics card if there is one.
enum class Gl { osmesa, egl };

/// The choice that was configured as RIGOR_GL.
Gl default_gl();

/// @param text  "osmesa" or "egl"
/// @throws InputError for any other text
Gl gl_from_text(const std::string& text);

struct OpenRenderer {
    std::unique_ptr<Renderer> renderer;
    std::string notice; // one line to show if the wanted library failed, otherwise empty
};

/// A renderer for this size [pixels], made with `gl` or, if that fails, with the other library.
/// @throws InputError for a size that is not supported, std::runtime_error if neither library works
OpenRenderer open_renderer(int width, int height, Gl gl = default_gl());

/// @throws InputError unless a picture of this size can be drawn
void check_size(int width, int height);

} // namespace rigor
