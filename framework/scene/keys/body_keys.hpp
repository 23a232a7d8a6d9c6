// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

namespace rigor {

/// Appends the body that an entry of "bodies" describes, or all bodies of its grid.
/// @throws Mistake
void read_body(const Value& value, MeshLibrary& meshes, std::vector<BodyDescription>& bodies);

void body_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
