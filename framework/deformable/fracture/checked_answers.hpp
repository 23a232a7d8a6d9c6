// SPDX-License-Identifier: MIT
// Checks of what the formulas of topic `fracture` return. A student may have written the formulas,
// and the engine uses the numbers that they return as indices into its own arrays.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

// Each function returns its argument, or throws std::out_of_range. The message names the formula,
// what was expected and what was found.

/// @param elements  number of elements; one stress is expected for each element
std::vector<Matrix3d> checked_stresses(std::vector<Matrix3d> smooth, std::size_t elements);

/// @return `face`, the index of a face in its tetrahedron, 0 … 3
int checked_face(int face);

/// @param before  the mesh that was split
SplitMesh checked_split(SplitMesh split, const TetrahedralMesh& before, const char* formula);

/// Checks a split by `split_along_faces`, where the number of elements has to stay the same.
SplitMesh checked_split_along_faces(SplitMesh split, const TetrahedralMesh& before);

/// @param before  the mesh without cracks
EmbeddedMesh checked_embedding(EmbeddedMesh embedded, const TetrahedralMesh& before);

} // namespace rigor
