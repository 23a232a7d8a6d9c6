// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/shaders/look.hpp"

namespace rigor {

/// The shaders of a look.
ShaderSource source(Look look);

} // namespace rigor
