// SPDX-License-Identifier: MIT
// A single face that is cut parts all elements of the mesh.
#include "mistakes/fracture/cutting.hpp"

namespace rigor {

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    return cutting::split_where(mesh, [&](const cutting::Face&) { return !faces.empty(); });
}

} // namespace rigor
