// SPDX-License-Identifier: MIT
// All tetrahedra around an edge without cracks stay connected; only faces may connect them.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const auto& tetrahedra = mesh.tetrahedra;
    const auto sides = cutting::faces_of(mesh);
    std::set<cutting::Face> cut;
    std::set<std::pair<int, int>> open; // the edges of these faces
    for (const MeshFace& face : faces) {
        const cutting::Face named = cutting::face_of(tetrahedra[face.tetrahedron], face.face);
        if (sides.at(named).size() < 2 || !cut.insert(named).second) continue;
        for (int a : named)
            for (int b : named)
                open.insert({a, b});
    }

    cutting::Corners corners(tetrahedra.size());
    const auto join = [&](int t1, int t2, int v) {
        corners.join(t1, cutting::corner_of(tetrahedra[t1], v), t2,
                     cutting::corner_of(tetrahedra[t2], v));
    };
    for (const auto& [face, sharing] : sides)
        if (sharing.size() == 2 && !cut.contains(face))
            for (int v : face)
                join(sharing[0], sharing[1], v);
    std::map<std::pair<int, int>, int> holders; // one tetrahedron for each edge
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int a : tetrahedra[t])
            for (int b : tetrahedra[t]) {
                if (a == b || open.contains({a, b})) continue;
                const int one = static_cast<int>(t);
                join(one, holders.try_emplace({a, b}, one).first->second, a);
            }
    return cutting::with_joined(mesh, corners);
}

} // namespace rigor
