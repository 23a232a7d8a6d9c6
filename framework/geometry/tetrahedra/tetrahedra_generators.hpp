// SPDX-License-Identifier: MIT
// Meshes of tetrahedra of simple solids. A block is divided into cells, and each cell into five
// tetrahedra: one in the middle, with a third of the volume, and four corners. Neighboring cells
// are mirror images of each other, so that their faces match. With an even number of cells along an
// axis, the mesh is its own mirror image along that axis.
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A block about the origin: a bar, a beam or a plate.
///
/// @param size   edge lengths along x, y, z [m]
/// @param cells  number of cells along x, y, z; at least 1 each
TetrahedralMesh block_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells);

/// A block with a notch in the middle of its upper side. The notch runs through the whole block
/// along z. If an odd number of cells remains beside it along x, the notch is half a cell off the
/// middle, towards -x.
///
/// @param notch  size of the notch in cells: along x, and from the top down along y; each less
///               than the number in `cells` along that axis
TetrahedralMesh notched_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                   const std::array<int, 2>& notch);

/// A ball about the origin: an octahedron of 8 · layers³ tetrahedra, whose vertices are moved
/// radially onto spheres. The mesh is its own mirror image along x, y and z.
/// @param layers  number of tetrahedra from the center to the surface along each axis
TetrahedralMesh ball_tetrahedra(double radius, int layers);

} // namespace rigor
