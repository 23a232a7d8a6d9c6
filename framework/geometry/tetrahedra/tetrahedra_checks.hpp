// SPDX-License-Identifier: MIT
// The conditions under which a mesh of tetrahedra is a solid.
#pragma once

#include "geometry/meshes/mesh_error.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

namespace rigor {

/// Refuses a mesh that is not one solid. It must have tetrahedra, and not too many. Vertices must
/// exist, be finite and belong to a tetrahedron. No tetrahedron may be inverted or flat (its volume
/// below 1e-9 of the cube of its longest edge). A face may belong to two tetrahedra at most, on
/// different sides. All tetrahedra must be connected through faces, because a shared edge or vertex
/// alone does not hold two parts together.
///
/// @param lines  line of the text for each tetrahedron, for the error; empty if there is no text
/// @throws MeshError
void check_mesh(const TetrahedralMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
