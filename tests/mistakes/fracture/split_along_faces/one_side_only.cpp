// SPDX-License-Identifier: MIT
// A face is cut only if it is given by the tetrahedron that comes first in the mesh.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::map<cutting::Face, std::vector<int>> sides = cutting::faces_of(mesh);
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces) {
        const cutting::Face vertices =
            cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face);
        if (sides[vertices][0] == face.tetrahedron) cut.insert(vertices);
    }
    return cutting::split_where(mesh,
                                [&](const cutting::Face& face) { return cut.contains(face); });
}

} // namespace rigor
