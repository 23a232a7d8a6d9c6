// SPDX-License-Identifier: MIT
// The faces that are cut are known by a key with six decimal digits for each vertex. In a mesh with
// more than a million vertices another face may have the same key, and opens too.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto key_of = [](const cutting::Face& face) {
        long long key = 0;
        for (const int v : face)
            key = key * 1000000 + v;
        return key;
    };
    std::set<long long> cut;
    for (const MeshFace& face : faces)
        cut.insert(key_of(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face)));
    return cutting::split_where(
        mesh, [&](const cutting::Face& face) { return cut.contains(key_of(face)); });
}

} // namespace rigor
