// SPDX-License-Identifier: MIT
// Vertices are duplicated only between separate pieces, so a crack that ends inside stays closed.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    // Tetrahedra that are connected through uncut faces form a piece.
    cutting::Corners pieces(mesh.tetrahedra.size());
    for (const auto& [face, sharing] : cutting::faces_of(mesh))
        if (sharing.size() == 2 && !cut.contains(face))
            for (int c = 0; c < 4; ++c)
                pieces.join(sharing[0], 0, sharing[1], 0);
    cutting::Corners corners(mesh.tetrahedra.size());
    // The first corner found for each vertex and piece.
    std::map<std::pair<int, int>, std::pair<int, int>> first;
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const int t = static_cast<int>(i);
            const auto [entry, is_new] =
                first.try_emplace({mesh.tetrahedra[i][c], pieces.find(4 * t)}, t, c);
            corners.join(t, c, entry->second.first, entry->second.second);
        }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
