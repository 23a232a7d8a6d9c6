// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/context.hpp"
#include "render/renderer.hpp"

#include <memory>

namespace rigor {

/// A renderer that draws in a context. What a scene does not need is not even compiled: each
/// shader, mesh and map is made when the first picture asks for it.
std::unique_ptr<Renderer> make_drawing(std::unique_ptr<Context> context, int width, int height);

} // namespace rigor

/// What a module exports. The caller owns the renderer.
extern "C" rigor::Renderer* create_renderer(int width, int height);
