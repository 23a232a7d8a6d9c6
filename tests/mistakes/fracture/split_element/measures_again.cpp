// SPDX-License-Identifier: MIT
// Measures again when the longest edge is split: what was on the plane is on it no more.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace rigor {

namespace {

bool has(const std::array<int, 4>& tetrahedron, int vertex)
{
    return std::find(tetrahedron.begin(), tetrahedron.end(), vertex) != tetrahedron.end();
}

SplitMesh unchanged(const TetrahedralMesh& mesh)
{
    SplitMesh same;
    same.mesh = mesh;
    for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v)
        same.origins.push_back({v, v, 0});
    for (int e = 0; e < static_cast<int>(mesh.tetrahedra.size()); ++e)
        same.parents.push_back(e);
    return same;
}

/// The heights of the vertices around `vertex`; those that count as lying on the plane are 0 in
/// `heights` and as they are in `exact`.
struct Plane {
    std::vector<double> heights, exact;
    bool above = false, below = false; // whether a vertex is
};

Plane measure(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    Plane plane;
    plane.exact.assign(mesh.vertices.size(), 0);
    double longest = 0;
    std::vector<int> around;
    for (const auto& t : mesh.tetrahedra) {
        if (!has(t, vertex)) continue;
        for (const int a : t) {
            around.push_back(a);
            plane.exact[a] = normal.dot(mesh.vertices[a] - mesh.vertices[vertex]);
            for (const int b : t)
                longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
        }
    }
    plane.heights = plane.exact;
    for (const int a : around) {
        if (std::abs(plane.heights[a]) < 0.05 * longest) plane.heights[a] = 0;
        plane.above = plane.above || plane.heights[a] > 0;
        plane.below = plane.below || plane.heights[a] < 0;
    }
    return plane;
}

/// An edge of a tetrahedron at `vertex` that crosses the plane, from above to below.
std::optional<std::pair<int, int>> crossing_edge(const TetrahedralMesh& mesh, int vertex,
                                                 const std::vector<double>& heights)
{
    for (const auto& t : mesh.tetrahedra) {
        if (!has(t, vertex)) continue;
        for (const int a : t)
            for (const int b : t)
                if (heights[a] > 0 && heights[b] < 0) return std::pair(a, b);
    }
    return std::nullopt;
}

/// Splits the edge from a to b at the fraction t, in all tetrahedra that have it.
void split_edge(SplitMesh& cut, int a, int b, double t)
{
    auto& vertices = cut.mesh.vertices;
    const int p = static_cast<int>(vertices.size());
    const Vector3d x = (1 - t) * vertices[a] + t * vertices[b];
    vertices.push_back(x);
    cut.origins.push_back({a, b, t});
    auto& tetrahedra = cut.mesh.tetrahedra;
    for (std::size_t e = 0, count = tetrahedra.size(); e < count; ++e) {
        if (!has(tetrahedra[e], a) || !has(tetrahedra[e], b)) continue;
        std::array<int, 4> part = tetrahedra[e];
        std::replace(part.begin(), part.end(), a, p);
        std::replace(tetrahedra[e].begin(), tetrahedra[e].end(), b, p);
        tetrahedra.push_back(part);
        cut.parents.push_back(cut.parents[e]);
    }
}

/// Splits the mesh between the tetrahedra at `vertex` that are on different sides.
SplitMesh part(const SplitMesh& cut, int vertex, const std::vector<bool>& is_above)
{
    const auto& tetrahedra = cut.mesh.tetrahedra;
    std::map<std::array<int, 3>, int> seen; // faces, and the tetrahedron found first
    std::vector<MeshFace> faces;
    for (int e = 0; e < static_cast<int>(tetrahedra.size()); ++e) {
        if (!has(tetrahedra[e], vertex)) continue;
        for (int f = 0; f < 4; ++f) {
            std::array<int, 3> key;
            for (int i = 0; i < 3; ++i)
                key[i] = tetrahedra[e][(f + 1 + i) % 4];
            std::sort(key.begin(), key.end());
            const auto [at, is_new] = seen.emplace(key, e);
            if (!is_new && is_above[at->second] != is_above[e]) faces.push_back({e, f});
        }
    }
    SplitMesh split = split_along_faces(cut.mesh, faces);
    for (VertexOrigin& origin : split.origins)
        origin = cut.origins[origin.first];
    for (int& parent : split.parents)
        parent = cut.parents[parent];
    return split;
}

/// Whether each tetrahedron is above the plane.
std::vector<bool> sides(const TetrahedralMesh& mesh, const Plane& plane)
{
    std::vector<bool> is_above;
    for (const auto& t : mesh.tetrahedra) {
        double sum = 0, exact = 0;
        for (const int a : t) {
            sum += plane.heights[a];
            exact += plane.exact[a];
        }
        is_above.push_back(sum != 0 ? sum > 0 : exact >= 0);
    }
    return is_above;
}

} // namespace

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    SplitMesh cut = unchanged(mesh);
    Plane plane = measure(mesh, vertex, normal);
    if (!plane.above || !plane.below) return cut;
    while (const auto edge = crossing_edge(cut.mesh, vertex, plane.heights)) {
        const auto [a, b] = *edge;
        split_edge(cut, a, b, plane.heights[a] / (plane.heights[a] - plane.heights[b]));
        plane = measure(cut.mesh, vertex, normal); // a new vertex is nearer than 0.05 anyway
    }
    return part(cut, vertex, sides(cut.mesh, plane));
}

} // namespace rigor
