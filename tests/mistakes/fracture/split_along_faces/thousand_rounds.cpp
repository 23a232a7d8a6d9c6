// SPDX-License-Identifier: MIT
// Labels spread from corner to corner in at most a thousand rounds, which is too few for an edge
// with thousands of tetrahedra around it.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    std::vector<std::array<int, 2>> links;
    for (const auto& [face, sharing] : cutting::faces_of(mesh))
        if (sharing.size() == 2 && !cut.contains(face))
            for (const int v : face)
                links.push_back(
                    {4 * sharing[0] + cutting::corner_of(mesh.tetrahedra[sharing[0]], v),
                     4 * sharing[1] + cutting::corner_of(mesh.tetrahedra[sharing[1]], v)});

    std::vector<int> labels(4 * mesh.tetrahedra.size());
    std::iota(labels.begin(), labels.end(), 0);
    for (int round = 0; round < 1000; ++round)
        for (const auto& [a, b] : links)
            labels[a] = labels[b] = std::min(labels[a], labels[b]);
    cutting::Corners corners(mesh.tetrahedra.size());
    std::map<int, int> first; // for each label, the first corner that has it
    for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
        const int other = first.emplace(labels[i], i).first->second;
        corners.join(i / 4, i % 4, other / 4, other % 4);
    }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
