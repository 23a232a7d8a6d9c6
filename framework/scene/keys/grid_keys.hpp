// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Appends copies of a body in a grid: {"count": [5, 4, 5], "spacing": [1.1, 1.1, 1.1], …}.
/// @throws Mistake
void read_grid(const Value& value, const BodyDescription& body,
               std::vector<BodyDescription>& bodies);

void grid_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
