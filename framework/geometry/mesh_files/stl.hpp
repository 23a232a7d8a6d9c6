// SPDX-License-Identifier: MIT
// Triangle meshes in the STL format of stereolithography, as text or binary.
#pragma once

#include "geometry/mesh_files/surface_text.hpp"

namespace rigor {

/// Reads the triangles of an STL file. Corners with the same coordinates become one vertex, since
/// the format does not say which triangles are connected. Normals in the file are skipped: the
/// order of the corners says where the outside is.
///
/// A binary file is recognized by its length: 84 bytes and 50 more for each triangle. Its bytes 80
/// to 83, counted from 0, are the number of triangles. A text begins with `solid`.
///
/// @throws MeshError
SurfaceText read_stl(std::string_view bytes);

} // namespace rigor
