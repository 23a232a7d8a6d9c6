// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/shaders/look.hpp"

namespace rigor {

/// The shaders of text and patches.
ShaderSource letter_source(Look look);

} // namespace rigor
