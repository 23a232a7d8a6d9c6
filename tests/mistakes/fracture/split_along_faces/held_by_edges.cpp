// SPDX-License-Identifier: MIT
// Tetrahedra that share only an edge stay connected; only a face may connect them.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    cutting::Corners corners(mesh.tetrahedra.size());
    std::map<std::pair<int, int>, int> holders; // one tetrahedron for each edge
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
        const int t = static_cast<int>(i);
        for (int a : mesh.tetrahedra[i])
            for (int b : mesh.tetrahedra[i]) {
                if (a >= b) continue;
                const auto [entry, is_new] = holders.try_emplace({a, b}, t);
                for (int v : {a, b})
                    corners.join(t, cutting::corner_of(mesh.tetrahedra[i], v), entry->second,
                                 cutting::corner_of(mesh.tetrahedra[entry->second], v));
            }
    }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
