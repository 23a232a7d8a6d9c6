// SPDX-License-Identifier: MIT
// The faces that are cut are known by a key with 20 bits for each vertex. In a mesh with more than
// a million vertices another face may have the same key, and opens too.
#include "mistakes/fracture/cutting.hpp"

#include <cstdint>

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto key_of = [](const cutting::Face& face) {
        std::uint64_t key = 0;
        for (const int v : face)
            key = (key << 20) + static_cast<std::uint64_t>(v);
        return key;
    };
    std::set<std::uint64_t> cut;
    for (const MeshFace& face : faces)
        cut.insert(key_of(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face)));
    return cutting::split_where(
        mesh, [&](const cutting::Face& face) { return cut.contains(key_of(face)); });
}

} // namespace rigor
