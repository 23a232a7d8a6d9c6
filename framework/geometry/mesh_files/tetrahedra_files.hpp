// SPDX-License-Identifier: MIT
// Meshes of tetrahedra as text: `.msh` of Gmsh, in its formats 2.2 and 4.1, and `.mesh` of Medit.
#pragma once

#include "geometry/meshes/mesh_error.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// A mesh as it was read: the syntax of its text is right, but it has not passed `check_mesh` yet.
struct TetrahedraText {
    TetrahedralMesh mesh;   // without the vertices that no tetrahedron uses
    std::vector<int> lines; // for each tetrahedron, its line in the text
};

/// Reads the tetrahedra of a Gmsh text file and skips other elements; curved tetrahedra are
/// refused.
/// @throws MeshError
TetrahedraText read_msh(std::string_view text);

/// Reads the tetrahedra of a Medit file and skips other elements.
/// @throws MeshError
TetrahedraText read_medit(std::string_view text);

/// Reads a mesh of Gmsh or of Medit. The first token of the text tells the format.
/// @throws MeshError
TetrahedraText read_tetrahedra(std::string_view text);

/// The text of a mesh for Medit. Reading this text gives exactly the same coordinates.
std::string medit_text(const TetrahedralMesh& mesh);

} // namespace rigor
