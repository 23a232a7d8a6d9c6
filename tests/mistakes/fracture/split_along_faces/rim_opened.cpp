// SPDX-License-Identifier: MIT
// All three vertices of a cut face are duplicated, even those on the rim of the crack.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    std::set<int> torn;
    for (const cutting::Face& face : cut)
        torn.insert(face.begin(), face.end());
    return cutting::split_where(mesh, [&](const cutting::Face& face) {
        return cut.contains(face) ||
               (torn.contains(face[0]) && torn.contains(face[1]) && torn.contains(face[2]));
    });
}

} // namespace rigor
