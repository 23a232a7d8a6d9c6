// SPDX-License-Identifier: MIT
// Meshes of tetrahedra as text: `.msh` of Gmsh, in its formats 2.2 and 4.1, and `.mesh` of Medit.
#pragma once

#include "geometry/meshes/mesh_error.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// A mesh as it was read. It has passed no check but that of its syntax.
struct TetrahedraText {
    TetrahedralMesh mesh;   // only the vertices that a tetrahedron uses
    std::vector<int> lines; // of each tetrahedron in the text
};

/// The tetrahedra of a Gmsh file (its text form), whatever else is in it; curved ones are refused.
/// @throws MeshError
TetrahedraText read_msh(std::string_view text);

/// The tetrahedra of a Medit file, whatever else is in it.
/// @throws MeshError
TetrahedraText read_medit(std::string_view text);

/// Either, by its first word.
/// @throws MeshError
TetrahedraText read_tetrahedra(std::string_view text);

/// The text of a mesh for Medit; reading it again gives the same bits.
std::string medit_text(const TetrahedralMesh& mesh);

} // namespace rigor
