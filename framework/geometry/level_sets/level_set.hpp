// SPDX-License-Identifier: MIT
// The level set of a mesh: signed distances on a grid.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// The level set of a closed mesh (`check_mesh`): at every node the exact distance to the nearest
/// triangle [m], negative inside. The sign follows from the angle-weighted pseudonormal of the
/// nearest face, edge or vertex (Baerentzen and Aanaes 2005, "Signed distance computation using the
/// angle weighted pseudonormal"). The grid is symmetric about the middle of the mesh's bounds and
/// extends at least two cells beyond them.
///
/// @param cells  number of cells along the longest side of the bounds
LevelSet make_level_set(const TriangleMesh& mesh, int cells);

/// A number of cells along the longest side of the bounds, from 32 to 64. Within this range, it is
/// the smallest number at which walls are at least three cells thick, apart from the thinnest
/// walls, which may cover up to a tenth of the surface area.
int suggested_cells(const TriangleMesh& mesh);

} // namespace rigor
