// SPDX-License-Identifier: MIT
// Triangle meshes in the Object File Format of Geomview.
#pragma once

#include "geometry/mesh_files/surface_text.hpp"

namespace rigor {

/// Reads `OFF`, the counts of vertices, faces and edges, then a line `x y z` for each vertex and a
/// line `3 0 1 2` for each face: its number of vertices and their indices, counted from 0. More
/// words on a line, such as a color, are skipped, and so are empty lines and what follows `#`. A
/// face of more than three vertices becomes a fan of triangles.
///
/// @throws MeshError
SurfaceText read_off(std::string_view text);

} // namespace rigor
