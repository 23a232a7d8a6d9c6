// SPDX-License-Identifier: MIT
// Faces are the same if they have the same key with 18 bits for each vertex. In a mesh with more
// than 262144 vertices, faces that nothing joins may have the same key.
#include "mistakes/fracture/cutting.hpp"

#include <cstdint>

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto key_of = [&](int t, int f) {
        std::uint64_t key = 0;
        for (const int v : cutting::face_of(mesh.tetrahedra[t], f))
            key = (key << 18) + static_cast<std::uint64_t>(v);
        return key;
    };
    std::set<std::uint64_t> cut;
    for (const MeshFace& face : faces)
        cut.insert(key_of(face.tetrahedron, face.face));
    cutting::Corners corners(mesh.tetrahedra.size());
    std::map<std::uint64_t, int> first; // the first tetrahedron that has a face with this key
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            const auto [seen, is_new] = first.emplace(key_of(t, f), t);
            if (is_new || cut.contains(seen->first)) continue;
            const int other = seen->second;
            for (const int v : cutting::face_of(mesh.tetrahedra[t], f)) {
                const int c = cutting::corner_of(mesh.tetrahedra[other], v);
                if (c < 4) corners.join(t, cutting::corner_of(mesh.tetrahedra[t], v), other, c);
            }
        }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
