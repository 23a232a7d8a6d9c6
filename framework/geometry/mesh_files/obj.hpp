// SPDX-License-Identifier: MIT
// Triangle meshes as text, in the OBJ format of Wavefront.
#pragma once

#include "geometry/mesh_files/surface_text.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Reads vertices `v x y z` and faces `f 1 2 3`, `f 1/1/1 2//2 -1 …`, and skips all other lines. A
/// face of more than three vertices becomes a fan of triangles about its first vertex.
///
/// @throws MeshError for an error of syntax, and as soon as there are too many vertices or
///     triangles
SurfaceText read_obj(std::string_view text);

/// The text of a mesh. Reading this text gives exactly the same coordinates.
std::string obj_text(const TriangleMesh& mesh);

} // namespace rigor
