// SPDX-License-Identifier: MIT
#pragma once

#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

namespace rigor {

/// The mesh of a solid, an object of one kind or of a file.
/// @throws Mistake
std::shared_ptr<const TetrahedralMesh> read_solid_mesh(const Value& value, MeshLibrary& meshes);

void tetrahedra_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
