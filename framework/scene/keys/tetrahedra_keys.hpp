// SPDX-License-Identifier: MIT
#pragma once

#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

namespace rigor {

/// Reads the mesh of a deformable solid: an object of one kind, or a file.
/// @throws Mistake
std::shared_ptr<const TetrahedralMesh> read_solid_mesh(const Value& value, MeshLibrary& meshes);

void tetrahedra_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
