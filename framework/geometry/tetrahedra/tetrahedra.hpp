// SPDX-License-Identifier: MIT
// Meshes of tetrahedra: volumes and faces.
#pragma once

#include "formulas/types.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// Larger meshes are refused: the limits bound run time and memory.
inline constexpr std::size_t most_tetrahedra = 1'000'000, most_tetrahedron_vertices = 1'000'000;

/// tetrahedron_faces[f] has the vertices of face f of a tetrahedron, which lies opposite vertex f.
/// The vertices are counter-clockwise seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> tetrahedron_faces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Signed volume, positive if (b - a, c - a, d - a) are right-handed [m³].
inline double tetrahedron_volume(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                                 const Vector3d& d)
{
    return (b - a).dot((c - a).cross(d - a)) / 6;
}

/// Signed volume of a tetrahedron of a mesh [m³].
double tetrahedron_volume(const TetrahedralMesh& mesh, int tetrahedron);

/// A face of a tetrahedron, its vertices in ascending order.
struct SortedFace {
    std::array<int, 3> vertices;
    bool is_even; // whether `vertices` is an even permutation of the counter-clockwise order
    int tetrahedron, face; // indices; `face` is from 0 to 3, as in `tetrahedron_faces`
};

/// All faces of all tetrahedra, sorted so that faces with the same vertices are neighbors.
std::vector<SortedFace> sorted_faces(const TetrahedralMesh& mesh);

/// For each tetrahedron and each of its faces, the tetrahedron on the other side, or -1 for none.
std::vector<std::array<int, 4>> face_neighbours(const TetrahedralMesh& mesh);

/// The boundary surface: the faces that belong to one tetrahedron only, counter-clockwise seen from
/// outside. The result has all vertices of the mesh, with the same indices.
TriangleMesh boundary(const TetrahedralMesh& mesh);

} // namespace rigor
