// SPDX-License-Identifier: MIT
// Finds the neighbors of tetrahedra and the surface of their mesh. All faces are sorted by their
// vertices, so that the two sides of an inner face become neighbors in the list. The surface then
// consists of the faces without a neighbor.
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

auto sort_key(const SortedFace& f)
{
    return std::tie(f.vertices, f.tetrahedron, f.face);
}

SortedFace sorted_face(const TetrahedralMesh& mesh, int tetrahedron, int face)
{
    SortedFace sorted{{}, true, tetrahedron, face};
    auto& v = sorted.vertices;
    for (int i = 0; i < 3; ++i)
        v[i] = mesh.tetrahedra[tetrahedron][tetrahedron_faces[face][i]];
    const auto order = [&](int i, int j) {
        if (v[i] <= v[j]) return;
        std::swap(v[i], v[j]);
        sorted.is_even = !sorted.is_even;
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return sorted;
}

} // namespace

std::vector<SortedFace> sorted_faces(const TetrahedralMesh& mesh)
{
    std::vector<SortedFace> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f)
            faces.push_back(sorted_face(mesh, t, f));
    std::sort(faces.begin(), faces.end(),
              [](const SortedFace& a, const SortedFace& b) { return sort_key(a) < sort_key(b); });
    return faces;
}

double tetrahedron_volume(const TetrahedralMesh& mesh, int tetrahedron)
{
    const auto& [a, b, c, d] = mesh.tetrahedra[tetrahedron];
    return tetrahedron_volume(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c],
                              mesh.vertices[d]);
}

std::vector<std::array<int, 4>> face_neighbours(const TetrahedralMesh& mesh)
{
    std::vector<std::array<int, 4>> neighbours(mesh.tetrahedra.size(), {-1, -1, -1, -1});
    const std::vector<SortedFace> faces = sorted_faces(mesh);
    for (std::size_t i = 1; i < faces.size(); ++i) {
        const SortedFace &f = faces[i - 1], &g = faces[i];
        if (f.vertices != g.vertices) continue;
        neighbours[f.tetrahedron][f.face] = g.tetrahedron;
        neighbours[g.tetrahedron][g.face] = f.tetrahedron;
    }
    return neighbours;
}

TriangleMesh boundary(const TetrahedralMesh& mesh)
{
    TriangleMesh surface{mesh.vertices, {}};
    const auto neighbours = face_neighbours(mesh);
    for (std::size_t t = 0; t < neighbours.size(); ++t)
        for (int f = 0; f < 4; ++f) {
            if (neighbours[t][f] >= 0) continue;
            const auto& [i, j, k] = tetrahedron_faces[f];
            const auto& v = mesh.tetrahedra[t];
            surface.triangles.push_back({v[i], v[j], v[k]});
        }
    return surface;
}

} // namespace rigor
