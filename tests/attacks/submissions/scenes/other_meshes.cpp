// SPDX-License-Identifier: MIT
// Returns meshes with vertices that do not exist, with a hundred thousand copies of an element, and
// without anything.
// topic: fracture
// tasks: A7.4 A7.5 A7.6 A7.7
// expect: 0 failed|crashed
#include "formulas/fracture.hpp"

#include <climits>

namespace rigor {

int closest_face(const std::array<Vector3d, 4>&, const Vector3d&)
{
    return INT_MIN;
}

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>&)
{
    SplitMesh split{mesh, {}, {}};
    for (auto& corners : split.mesh.tetrahedra)
        corners = {0, 1, 2, INT_MAX};
    split.origins.resize(split.mesh.vertices.size());
    split.parents.resize(split.mesh.tetrahedra.size());
    return split;
}

SplitMesh split_element(const TetrahedralMesh& mesh, int, const Vector3d&)
{
    SplitMesh split{mesh, {}, {}};
    split.mesh.tetrahedra.resize(100'000, mesh.tetrahedra.at(0));
    split.origins.resize(split.mesh.vertices.size());
    split.parents.resize(split.mesh.tetrahedra.size());
    return split;
}

EmbeddedMesh virtual_nodes(const TetrahedralMesh&, const std::vector<ElementCrack>&)
{
    return {};
}

} // namespace rigor
