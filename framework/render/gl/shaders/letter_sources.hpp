// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/shaders/look.hpp"

namespace rigor {

/// The shaders of `Look::text` or `Look::patch` (rectangles of one color).
ShaderSource letter_source(Look look);

} // namespace rigor
