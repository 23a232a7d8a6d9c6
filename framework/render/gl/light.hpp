// SPDX-License-Identifier: MIT
// The view: the camera, the sun and the size of the screen.
#pragma once

#include "render/gl/shaders/program.hpp"
#include "render/picture.hpp"

namespace rigor {

/// Side of the shadow map [pixels]. A larger one costs time and makes the edges of shadows harder.
constexpr int shadow_side = 1024;

/// The data that the shaders of a picture share. @param width, height  of the picture [pixels]
View view_of(const Picture& picture, int width, int height);

/// Distance from the camera to what it looks at, never 0 [m].
float camera_distance(const Picture& picture);

} // namespace rigor
