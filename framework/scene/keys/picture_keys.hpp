// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Where to look from, and what to draw besides the bodies.
/// @throws Mistake
Camera read_camera(const Value& value);
Overlays read_overlays(const Value& value);

void picture_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
