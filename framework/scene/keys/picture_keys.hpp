// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads the camera, and what is drawn in addition to the bodies and solids.
/// @throws Mistake
Camera read_camera(const Value& value);
Overlays read_overlays(const Value& value);

void picture_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
