// SPDX-License-Identifier: MIT
// The module that draws with OSMesa.
#include "render/gl/drawing.hpp"
#include "render/gl/osmesa_context.hpp"

rigor::Renderer* create_renderer(int width, int height)
{
    return rigor::make_drawing(rigor::make_osmesa_context(), width, height).release();
}
