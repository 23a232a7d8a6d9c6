// SPDX-License-Identifier: MIT
// The conditions under which a mesh of tetrahedra is a solid.
#pragma once

#include "geometry/meshes/mesh_error.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

namespace rigor {

/// Refuses a mesh that is not one solid. It must have tetrahedra, and not too many. Vertices must
/// exist, have coordinates of at most 1e12 m in size, and belong to a tetrahedron. No tetrahedron
/// may be inverted or flat (a volume of at most 1e-9 times the cube of its longest edge). A face
/// may belong to at most two tetrahedra, which lie on different sides of it. All tetrahedra must be
/// connected through faces, because a shared edge or vertex alone does not hold two parts together.
///
/// @param lines  for each tetrahedron, its line in the text of the mesh, which the error names;
///               empty if the mesh has no text
/// @throws MeshError
void check_mesh(const TetrahedralMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
