// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/context.hpp"
#include "render/renderer.hpp"

#include <memory>

namespace rigor {

/// A renderer that draws in a context. Each shader, mesh and map is made when the first picture
/// needs it, so that a scene does not wait for parts that it does not use.
std::unique_ptr<Renderer> make_drawing(std::unique_ptr<Context> context, int width, int height);

} // namespace rigor

/// The function that a module exports. The caller owns the renderer.
extern "C" rigor::Renderer* create_renderer(int width, int height);
