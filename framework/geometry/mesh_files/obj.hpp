// SPDX-License-Identifier: MIT
// Triangle meshes as text, in the format of Wavefront's OBJ.
#pragma once

#include "geometry/meshes/mesh_checks.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A mesh as it was read. It has passed no check but that of its syntax.
struct ObjMesh {
    TriangleMesh mesh;      // only the vertices that a face uses
    std::vector<int> lines; // of each triangle's face in the text
};

/// Vertices `v x y z` and faces `f 1 2 3`, `f 1/1/1 2//2 -1 …`; everything else is skipped. A face of
/// more than three vertices becomes a fan about its first.
/// @throws MeshError, at the first face too many without reading on
ObjMesh read_obj(std::string_view text);

/// The text of a mesh; reading it again gives the same bits.
std::string obj_text(const TriangleMesh& mesh);

} // namespace rigor
