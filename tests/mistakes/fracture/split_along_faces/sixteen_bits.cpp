// SPDX-License-Identifier: MIT
// A key with 16 bits for each vertex of a face is the same for two faces of a large mesh.
#include "mistakes/fracture/cutting.hpp"

#include <cstdint>

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto key_of = [&](int t, int f) {
        std::int64_t key = 0;
        for (const int v : cutting::face_of(mesh.tetrahedra[t], f))
            key = (key << 16) + v;
        return key;
    };
    std::set<std::int64_t> cut;
    for (const MeshFace& face : faces)
        cut.insert(key_of(face.tetrahedron, face.face));
    std::map<std::int64_t, std::array<int, 2>> first; // a tetrahedron and its face
    cutting::Corners corners(mesh.tetrahedra.size());
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            const auto [seen, is_new] = first.try_emplace(key_of(t, f), std::array{t, f});
            if (is_new || cut.contains(seen->first)) continue;
            const auto [other, g] = seen->second;
            const cutting::Face here = cutting::face_of(mesh.tetrahedra[t], f),
                                there = cutting::face_of(mesh.tetrahedra[other], g);
            for (int i = 0; i < 3; ++i)
                corners.join(t, cutting::corner_of(mesh.tetrahedra[t], here[i]), other,
                             cutting::corner_of(mesh.tetrahedra[other], there[i]));
        }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
