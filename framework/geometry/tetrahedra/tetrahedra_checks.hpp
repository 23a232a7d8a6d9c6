// SPDX-License-Identifier: MIT
// What a mesh of tetrahedra must be to be a solid.
#pragma once

#include "geometry/meshes/mesh_error.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

namespace rigor {

/// Refuses what is not one solid: no tetrahedron at all, too many, a vertex that is not a number, does
/// not exist or belongs to none, a tetrahedron that is flat (its volume under 1e-9 of its longest
/// edge's cube) or inverted, a face that three share or two from the same side, a solid in several
/// pieces. Pieces that meet in an edge or a vertex only do not hang together: nothing would hold them.
///
/// @param lines  of each tetrahedron in its text, to name in the error; empty: none
/// @throws MeshError
void check_mesh(const TetrahedralMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
