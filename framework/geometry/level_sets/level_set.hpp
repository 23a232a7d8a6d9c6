// SPDX-License-Identifier: MIT
// A mesh as signed distance on a grid.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// The level set of a closed mesh (`check_mesh`): at every node the exact distance to the nearest
/// triangle, with the sign that the normal of what lies nearest gives: of a face, of an edge the sum of
/// two, of a vertex the sum weighted by the angles (Baerentzen and Aanaes 2005, "Signed distance
/// computation using the angle weighted pseudonormal"). The grid lies symmetric about the mesh's
/// bounds and reaches two cells beyond them.
///
/// @param cells  along the longest side of the bounds
LevelSet make_level_set(const TriangleMesh& mesh, int cells);

/// Cells that the walls of a mesh ask for, three across, within 32 … 64: by the thickness that a tenth
/// of the surface stays below.
int suggested_cells(const TriangleMesh& mesh);

} // namespace rigor
