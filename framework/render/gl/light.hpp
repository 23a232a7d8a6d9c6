// SPDX-License-Identifier: MIT
// Where the camera and the sun stand.
#pragma once

#include "render/gl/shaders/program.hpp"
#include "render/picture.hpp"

namespace rigor {

constexpr int shadow_side =
    1024; // the shadow map's side [pixels]; a larger one costs time and hardens the edges

/// All that the shaders share about a picture of this size.
View view_of(const Picture& picture, int width, int height);

/// Distance from the camera to what it looks at, never 0 [m].
float camera_distance(const Picture& picture);

} // namespace rigor
