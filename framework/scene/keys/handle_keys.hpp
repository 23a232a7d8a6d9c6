// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads the handles and loads of a solid whose mesh, position and orientation are known.
/// @throws Mistake
std::vector<Handle> read_handles(const Value& value, const SolidDescription& solid);
std::vector<NodeLoad> read_loads(const Value& value, const SolidDescription& solid);

void handle_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
