// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

namespace rigor {

/// Appends the deformable solid that an entry of "solids" describes.
/// @throws Mistake
void read_solid(const Value& value, MeshLibrary& meshes, std::vector<SolidDescription>& solids);

void solid_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
