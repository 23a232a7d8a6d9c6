// SPDX-License-Identifier: MIT
// A single face whose two tetrahedra have no face on the surface stays closed. But its edges may be
// on the surface.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    if (cut.size() == 1) {
        auto all = cutting::faces_of(mesh);
        bool is_inside = true;
        for (const int t : all[*cut.begin()])
            for (int f = 0; f < 4; ++f)
                is_inside &= all[cutting::face_of(mesh.tetrahedra[t], f)].size() == 2;
        if (is_inside) cut.clear();
    }
    return cutting::split_where(mesh,
                                [&](const cutting::Face& face) { return cut.contains(face); });
}

} // namespace rigor
