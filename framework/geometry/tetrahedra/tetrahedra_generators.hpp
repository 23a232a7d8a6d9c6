// SPDX-License-Identifier: MIT
// Meshes of tetrahedra of simple solids. A block is divided into cells, and each cell into five
// tetrahedra: one in the middle, with a third of the volume, and four corners. Neighbouring cells are
// mirror images of each other, so the mesh conforms; with an even number of cells along an axis it is
// its own mirror image along that axis.
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A block about the origin: bar, beam, plate. @param cells  along x, y, z; at least 1 each
TetrahedralMesh block_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells);

/// A block with a notch that comes down in the middle of its upper side and goes through along z.
/// @param notch  cells that are missing along x and down along y, each less than there are
TetrahedralMesh notched_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                   const std::array<int, 2>& notch);

/// A ball about the origin: an octahedron of 8 layers³ tetrahedra, blown up. It is its own mirror image
/// in x, y and z.
TetrahedralMesh ball_tetrahedra(double radius, int layers);

} // namespace rigor
