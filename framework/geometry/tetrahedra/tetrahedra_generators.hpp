// SPDX-License-Identifier: MIT
// Meshes of tetrahedra of simple solids. A block is divided into cells, and each cell into five
// tetrahedra: one in the middle, with a third of the volume, and four corners. Neighbouring cells
// are mirror images of each other, so the mesh conforms. With an even number of cells along an
// axis, the mesh is its own mirror image along that axis.
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A block about the origin: a bar, a beam or a plate.
///
/// @param size   edge lengths along x, y, z [m]
/// @param cells  along x, y, z; at least 1 each
TetrahedralMesh block_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells);

/// A block with a notch in the middle of its upper side. The notch runs through the whole block
/// along z.
///
/// @param notch  number of missing cells along x and down along y, each less than the number in
///               `cells`
TetrahedralMesh notched_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                   const std::array<int, 2>& notch);

/// A ball about the origin: an octahedron of 8 · layers³ tetrahedra, whose vertices are moved
/// radially onto spheres. It is its own mirror image in x, y and z.
TetrahedralMesh ball_tetrahedra(double radius, int layers);

} // namespace rigor
