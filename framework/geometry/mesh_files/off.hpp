// SPDX-License-Identifier: MIT
// Triangle meshes in the Object File Format of Geomview.
#pragma once

#include "geometry/mesh_files/surface_text.hpp"

namespace rigor {

/// Reads `OFF`, the numbers of vertices, faces and edges, then a line `x y z` for each vertex and a
/// line `3 0 1 2` for each face, with vertices from 0. What follows on a line, such as a color, is
/// skipped, and so are empty lines and what follows `#`. A face of more than three vertices becomes
/// a fan of triangles.
///
/// @throws MeshError
SurfaceText read_off(std::string_view text);

} // namespace rigor
