// SPDX-License-Identifier: MIT
// A vertex gets 64 copies at most, so all further groups around it share the last one.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    SplitMesh split =
        cutting::split_where(mesh, [&](const cutting::Face& face) { return cut.contains(face); });
    std::map<int, std::vector<int>> copies;
    for (std::size_t v = 0; v < split.origins.size(); ++v)
        copies[split.origins[v].first].push_back(static_cast<int>(v));
    cutting::Corners corners(mesh.tetrahedra.size());
    std::map<int, int> holders; // a corner for each vertex
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (int c = 0; c < 4; ++c) {
            int v = split.mesh.tetrahedra[t][c];
            const std::vector<int>& all = copies[split.origins[v].first];
            const auto place = std::find(all.begin(), all.end(), v) - all.begin();
            if (place >= 64) v = all[63];
            const int first = holders.emplace(v, 4 * t + c).first->second;
            corners.join(t, c, first / 4, first % 4);
        }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
