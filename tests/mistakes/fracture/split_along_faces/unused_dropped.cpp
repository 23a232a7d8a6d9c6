// SPDX-License-Identifier: MIT
// A vertex that no tetrahedron uses must stay in the mesh.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    const auto is_cut = [&](const cutting::Face& face) { return cut.contains(face); };
    return cutting::split_where(mesh, is_cut, false);
}

} // namespace rigor
