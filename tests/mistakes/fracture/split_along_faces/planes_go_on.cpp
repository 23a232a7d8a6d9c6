// SPDX-License-Identifier: MIT
// Each given face opens all faces of the mesh that lie on its plane.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const std::vector<Vector3d>& x = mesh.vertices;
    std::vector<std::pair<Vector3d, Vector3d>> planes; // a point and the unit normal
    for (const MeshFace& face : faces) {
        const auto [a, b, c] = cutting::face_of(mesh.tetrahedra[face.tetrahedron], face.face);
        planes.emplace_back(x[a], (x[b] - x[a]).cross(x[c] - x[a]).normalized());
    }
    return cutting::split_where(mesh, [&](const cutting::Face& face) {
        for (const auto& [point, n] : planes) {
            double farthest = 0;
            for (const int v : face)
                farthest = std::max(farthest, std::abs(n.dot(x[v] - point)));
            if (farthest < 1e-9) return true;
        }
        return false;
    });
}

} // namespace rigor
