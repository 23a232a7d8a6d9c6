// SPDX-License-Identifier: MIT
// The laws of every cut through elements (A7.6), written from the definition.
#pragma once

#include "fracture_laws.hpp"

namespace rigor::testing {

inline constexpr double snap_distance = 0.05; // fraction of the longest edge, as in the header

// Heights above the plane of the vertices of all tetrahedra that have `vertex`. A vertex that
// counts as on the plane has the height 0. `margin` is the least distance of a height from the
// threshold where this flips, as a fraction of the longest edge.
struct Heights {
    std::map<int, double> of;
    double margin = 1;
};

inline Heights heights(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    Heights result;
    double longest = 0;
    for (const Tetrahedron& t : mesh.tetrahedra)
        if (corner_of(t, vertex) < 4)
            for (int a : t) {
                result.of[a] = n.dot(mesh.vertices[a] - mesh.vertices[vertex]);
                for (int b : t)
                    longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
            }
    for (auto& [v, h] : result.of) {
        result.margin = std::min(result.margin, std::abs(std::abs(h) / longest - snap_distance));
        if (std::abs(h) < snap_distance * longest) h = 0;
    }
    return result;
}

// Checks that new vertices lie on exactly those edges of the vertex's tetrahedra that the plane
// cuts, and at the right place on them.
inline void check_new_vertices(const TetrahedralMesh& mesh, const SplitMesh& result, int vertex,
                               const Vector3d& n)
{
    const std::map<int, double> h = heights(mesh, vertex, n).of;
    std::map<std::array<int, 2>, double> expected; // where each edge a < b is cut
    for (const Tetrahedron& t : mesh.tetrahedra)
        if (corner_of(t, vertex) < 4)
            for (int a : t)
                for (int b : t)
                    if (a < b && h.at(a) * h.at(b) < 0)
                        expected[{a, b}] = h.at(a) / (h.at(a) - h.at(b));

    std::set<std::array<int, 2>> found;
    for (const auto& [first, second, t] : result.origins) {
        if (first == second || t == 0 || t == 1) continue; // an old vertex
        const std::array<int, 2> edge = {std::min(first, second), std::max(first, second)};
        CAPTURE(edge[0], edge[1]);
        check_that(expected.contains(edge), "a new vertex lies on an edge that the plane cuts");
        INFO("where on its edge a new vertex is");
        REQUIRE_THAT(first < second ? t : 1 - t, IsClose(expected[edge], Rounding(256, 1)));
        found.insert(edge);
    }
    check_count(found.size(), expected.size(),
                "edges with a new vertex, those that the plane cuts");
}

// Checks that all matter around each copy of the vertex is on one side of the plane, and that both
// sides have a copy.
inline void check_sides(const TetrahedralMesh& mesh, const SplitMesh& result, int vertex,
                        const Vector3d& n)
{
    const std::map<int, double> h = heights(mesh, vertex, n).of;
    const auto height_of = [&](int v) { // height of a vertex of `result`
        const auto& [first, second, t] = result.origins[v];
        const bool is_old = first == second || t == 0 || t == 1;
        return is_old ? h.at(t == 1 ? second : first) : 0.0;
    };
    std::map<int, std::array<bool, 2>> sides; // matter above and below each copy
    for (const Tetrahedron& t : result.mesh.tetrahedra)
        for (int copy : t) {
            const VertexOrigin& origin = result.origins[copy];
            if (origin.first != vertex || origin.second != vertex) continue;
            for (int v : t) {
                sides[copy][0] |= height_of(v) > 0;
                sides[copy][1] |= height_of(v) < 0;
            }
        }
    int above = 0, below = 0;
    for (const auto& [copy, side] : sides) {
        CAPTURE(copy);
        check_that(side[0] != side[1],
                   "all matter around a copy of the vertex is above the plane, or all is below");
        ++(side[0] ? above : below);
    }
    check_that(above > 0, "a copy of the vertex has matter above the plane");
    check_that(below > 0, "a copy of the vertex has matter below the plane");
}

// Checks that the parts of a tetrahedron that does not have the vertex stay together.
inline void check_beside(const TetrahedralMesh& mesh, const SplitMesh& result, int vertex)
{
    std::map<int, std::vector<Tetrahedron>> parts; // for each tetrahedron without the vertex
    for (std::size_t t = 0; t < result.parents.size(); ++t)
        if (corner_of(mesh.tetrahedra[result.parents[t]], vertex) == 4)
            parts[result.parents[t]].push_back(result.mesh.tetrahedra[t]);
    const auto have_a_face = [](const Tetrahedron& a, const Tetrahedron& b) {
        return std::count_if(a.begin(), a.end(), [&](int v) { return corner_of(b, v) < 4; }) == 3;
    };
    for (const auto& [parent, list] : parts) {
        CAPTURE(parent);
        std::vector<Tetrahedron> found = {list[0]}, others(list.begin() + 1, list.end());
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = others.size(); k-- > 0;)
                if (have_a_face(found[i], others[k])) {
                    found.push_back(others[k]);
                    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
                }
        check_count(found.size(), list.size(),
                    "parts of a tetrahedron without the vertex that hang together");
    }
}

// Cuts a mesh at a vertex, and checks what holds for every cut that has matter on both sides.
inline SplitMesh cut_at(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    const SplitMesh result = split_element(mesh, vertex, n);
    check_split(mesh, result);
    check_new_vertices(mesh, result, vertex, n);
    check_sides(mesh, result, vertex, n);
    check_beside(mesh, result, vertex);
    return result;
}

} // namespace rigor::testing
