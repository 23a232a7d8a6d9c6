// SPDX-License-Identifier: MIT
// The origin of a vertex that no tetrahedron uses is this vertex itself, and not vertex 0.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::set<cutting::Face> cut;
    for (const MeshFace& face : faces)
        cut.insert(cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face));
    SplitMesh result =
        cutting::split_where(mesh, [&](const cutting::Face& face) { return cut.contains(face); });
    std::set<int> used;
    for (const cutting::Tetrahedron& t : result.mesh.tetrahedra)
        used.insert(t.begin(), t.end());
    for (int v = 0; v < static_cast<int>(result.origins.size()); ++v)
        if (!used.contains(v)) result.origins[v] = {};
    return result;
}

} // namespace rigor
