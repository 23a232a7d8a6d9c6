// SPDX-License-Identifier: MIT
// Checks of the answers of the formulas of fracture. They may be a student's, and the engine uses
// them as indices into its own arrays.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

// Each function returns its argument, or throws std::out_of_range that names the formula, what was
// expected and what was found.

/// @param elements  number of elements
std::vector<Matrix3d> checked_stresses(std::vector<Matrix3d> smooth, std::size_t elements);

/// @return the number of a face, 0 … 3
int checked_face(int face);

/// @param before  the mesh that was split
SplitMesh checked_split(SplitMesh split, const TetrahedralMesh& before, const char* formula);

/// A split along faces, which also keeps the elements.
SplitMesh checked_split_along_faces(SplitMesh split, const TetrahedralMesh& before);

/// @param before  the mesh without cracks
EmbeddedMesh checked_embedding(EmbeddedMesh embedded, const TetrahedralMesh& before);

} // namespace rigor
