// SPDX-License-Identifier: MIT
// Returns the largest or the smallest index wherever a formula of fracture returns one: a vertex,
// a parent, an origin. Each of them would point far past an array of the grader.
// topic: fracture
// tasks: A7.4 A7.5 A7.6 A7.7 A7.8
// expect: 0 failed|crashed|not_implemented|compile_error
#include "formulas/fracture.hpp"

#include <climits>

namespace rigor {

namespace {

// Each list is as long as it must be, so that the lengths do not give the attack away.
SplitMesh pointing_to_nowhere(const TetrahedralMesh& mesh)
{
    static unsigned calls = 0;
    SplitMesh split{mesh, {}, {}};
    split.origins.resize(mesh.vertices.size());
    split.parents.resize(mesh.tetrahedra.size());
    for (std::size_t i = 0; i < split.parents.size(); ++i)
        split.parents[i] = static_cast<int>(i);
    for (std::size_t i = 0; i < split.origins.size(); ++i)
        split.origins[i].first = split.origins[i].second = static_cast<int>(i);
    const int nowhere = calls / 3 % 2 == 0 ? INT_MAX : INT_MIN;
    switch (calls++ % 3) {
    case 0:
        split.mesh.tetrahedra.back()[3] = nowhere;
        break;
    case 1:
        split.parents.back() = nowhere;
        break;
    default:
        split.origins.back().second = nowhere;
    }
    return split;
}

} // namespace

int closest_face(const std::array<Vector3d, 4>&, const Vector3d&)
{
    return INT_MAX;
}

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>&)
{
    return pointing_to_nowhere(mesh);
}

SplitMesh split_element(const TetrahedralMesh& mesh, int, const Vector3d&)
{
    return pointing_to_nowhere(mesh);
}

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>&)
{
    EmbeddedMesh embedded;
    embedded.mesh = mesh;
    embedded.vertex_parents.assign(mesh.vertices.size(), INT_MAX);
    embedded.parents.assign(mesh.tetrahedra.size(), INT_MIN);
    embedded.real.assign(mesh.tetrahedra.size(), {INT_MAX, 1, 1, 1});
    embedded.fractions.assign(mesh.tetrahedra.size(), 1);
    return embedded;
}

} // namespace rigor
