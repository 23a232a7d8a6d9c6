// SPDX-License-Identifier: MIT
// The module that draws with EGL.
#include "render/gl/drawing.hpp"
#include "render/gl/egl_context.hpp"

rigor::Renderer* create_renderer(int width, int height)
{
    return rigor::make_drawing(rigor::make_egl_context(), width, height).release();
}
