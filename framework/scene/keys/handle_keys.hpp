// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// What holds and pulls a solid's nodes, once its mesh and its place are known.
/// @throws Mistake
std::vector<Handle> read_handles(const Value& value, const SolidDescription& solid);
std::vector<NodeLoad> read_loads(const Value& value, const SolidDescription& solid);

void handle_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
