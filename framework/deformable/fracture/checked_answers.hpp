// SPDX-License-Identifier: MIT
// Checks of what the formulas of topic `fracture` return. A student may have written the formulas,
// and the engine uses the numbers that they return as indices into its own arrays, divides by
// masses that follow from them, and computes for as long as the meshes are large.
#pragma once

#include "formulas/types.hpp"

#include <optional>
#include <vector>

namespace rigor {

// Each function returns its argument, or throws std::out_of_range. The message names the formula,
// what was expected and what was found.

/// @param elements  number of elements; one stress is expected for each element
std::vector<Matrix3d> checked_stresses(std::vector<Matrix3d> smooth, std::size_t elements);

/// @return `face`, the index of a face in its tetrahedron, 0 … 3
int checked_face(int face);

/// @return  `normal`, the normal of a crack, which is finite
std::optional<Vector3d> checked_normal(std::optional<Vector3d> normal);

/// Checks a split by a plane: lengths and indices, fractions from 0 to 1, each old element in 1 to
/// 6 parts, and no more vertices than the old ones and the corners of the elements.
/// @param before  the mesh that was split
SplitMesh checked_split_element(SplitMesh split, const TetrahedralMesh& before);

/// Checks a split by `split_along_faces` in the same way; each element stays whole.
SplitMesh checked_split_along_faces(SplitMesh split, const TetrahedralMesh& before);

/// Checks virtual nodes: as for a split, with 1 to 4 copies of each element, shares from 0 to 1,
/// and corners that are real or virtual.
/// @param before  the mesh without cracks
EmbeddedMesh checked_embedding(EmbeddedMesh embedded, const TetrahedralMesh& before);

} // namespace rigor
