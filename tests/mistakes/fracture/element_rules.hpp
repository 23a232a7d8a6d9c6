// SPDX-License-Identifier: MIT
// Correct cutting through elements (A7.6), with a switch for each mistake.
#pragma once

#include "mistakes/fracture/cutting.hpp"

#include <cstdint>

namespace rigor::cutting {

/// The rules of `split_element` (A7.6); each mistake changes one.
struct ElementRules {
    bool halves_neighbours = true;     // otherwise only tetrahedra at the vertex are split
    bool halves_only_fan = false;      // those around a cut edge that faces connect to the vertex
    bool halves_across_cracks = false; // also those with other vertices at the same places
    bool opens = true;                 // otherwise the mesh is only refined
    bool opens_rim = false;            // separates each tetrahedron at the vertex from all others
    bool merges_edges = false;         // takes edges for one whose keys of 32 bits are the same
    bool halves_in_the_middle = false;
    double nearly_the_middle = 0;    // a new vertex within this of it is moved to the middle
    double nearest_to_an_end = 0;    // the least distance of a new vertex from an end of its edge
    bool swaps_corners = false;      // in one of the two halves
    double snap_distance = 0.05;     // relative to the longest edge
    bool by_own_edges = false;       // the longest edge of the tetrahedra that have the vertex
    bool float_longest = false;      // the longest edge in single precision
    bool subtracts_heights = false;  // n·x - n·x_v, whose digits cancel far from the origin
    bool asks_for_both_sides = true; // otherwise it splits even if no vertex is above, or below
    // The side of a tetrahedron on the plane, from the height of its center: positive for above, 0
    // for neither.
    double (*side_on_plane)(double height) = [](double height) { return height >= 0 ? 1.0 : -1.0; };
    bool center_in_space = false; // a mean of places, not of heights: digits are lost far away
};

inline bool has(const Tetrahedron& t, int vertex)
{
    return corner_of(t, vertex) < 4;
}

/// The heights above the plane [m] of all vertices of the tetrahedra at `vertex`. A vertex closer
/// to the plane than the snap distance gets height 0.
inline std::map<int, double> heights_at(const ElementRules& rules, const TetrahedralMesh& mesh,
                                        int vertex, const Vector3d& n)
{
    std::map<int, double> heights, longest_own;
    double longest = 0;
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int a : t)
            for (int b : t)
                if (has(t, vertex)) {
                    const double length = (mesh.vertices[a] - mesh.vertices[b]).norm();
                    const Vector3d &x = mesh.vertices[a], &X = mesh.vertices[vertex];
                    heights[a] = rules.subtracts_heights ? n.dot(x) - n.dot(X) : n.dot(x - X);
                    longest = std::max(longest, length);
                    for (int c : t)
                        longest_own[c] = std::max(longest_own[c], length);
                }
    if (rules.float_longest) longest = static_cast<float>(longest);
    for (auto& [v, h] : heights) {
        const double limit = rules.snap_distance * (rules.by_own_edges ? longest_own[v] : longest);
        if (v == vertex || std::abs(h) < limit) h = 0;
    }
    return heights;
}

/// The tetrahedra that have the edge (a, b) and are connected to those that also have `vertex`,
/// through faces that have the edge.
inline std::set<std::size_t> fan_around(const std::vector<Tetrahedron>& tetrahedra, int a, int b,
                                        int vertex)
{
    std::set<std::size_t> fan;
    for (std::size_t before = 1; before != fan.size();) {
        before = fan.size();
        for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
            const Tetrahedron& t = tetrahedra[i];
            const auto touches = [&](std::size_t other) {
                return std::count_if(t.begin(), t.end(),
                                     [&](int v) { return has(tetrahedra[other], v); }) == 3;
            };
            if (has(t, a) && has(t, b) &&
                (has(t, vertex) || std::any_of(fan.begin(), fan.end(), touches)))
                fan.insert(i);
        }
    }
    return fan;
}

inline SplitMesh split_by(const ElementRules& rules, const TetrahedralMesh& mesh, int vertex,
                          const Vector3d& n)
{
    SplitMesh split = split_along_faces(mesh, {});
    std::map<int, double> heights = heights_at(rules, mesh, vertex, n);
    std::vector<Tetrahedron>& tetrahedra = split.mesh.tetrahedra;
    std::vector<Vector3d>& x = split.mesh.vertices;
    const auto some = [&](auto is_there) {
        return std::any_of(heights.begin(), heights.end(),
                           [&](const auto& height) { return is_there(height.second); });
    };
    const bool is_two_sided =
        some([](double h) { return h > 0; }) && some([](double h) { return h < 0; });
    if (rules.asks_for_both_sides && !is_two_sided) return split;

    // The corner that has this vertex; by mistake also one at the same place; 4 if there is none.
    const auto place_of = [&](const Tetrahedron& t, int v) {
        int c = corner_of(t, v);
        for (int k = 0; k < 4 && c == 4 && rules.halves_across_cracks; ++k)
            if (x[t[k]] == x[v]) c = k;
        return c;
    };
    std::set<std::pair<int, int>> edges;
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int a : t)
            for (int b : t)
                if (has(t, vertex) && heights[a] > 0 && heights[b] < 0) edges.insert({a, b});
    std::set<std::uint32_t> keys;
    for (const auto& [a, b] : edges) {
        const auto key = static_cast<std::uint32_t>(a * mesh.vertices.size() + b);
        if (!keys.insert(key).second && rules.merges_edges) continue;
        double exact = heights[a] / (heights[a] - heights[b]);
        if (std::abs(exact - 0.5) < rules.nearly_the_middle) exact = 0.5;
        const double t = rules.halves_in_the_middle ? 0.5
                                                    : std::clamp(exact, rules.nearest_to_an_end,
                                                                 1 - rules.nearest_to_an_end);
        const int p = static_cast<int>(x.size());
        x.push_back((1 - t) * x[a] + t * x[b]);
        split.origins.push_back({a, b, t});
        heights[p] = 0;
        std::set<std::size_t> fan;
        if (rules.halves_only_fan) fan = fan_around(tetrahedra, a, b, vertex);
        for (std::size_t i = 0, count = tetrahedra.size(); i < count; ++i) {
            const Tetrahedron whole = tetrahedra[i];
            const int at_a = place_of(whole, a), at_b = place_of(whole, b);
            if (at_a == 4 || at_b == 4) continue;
            if (!rules.halves_neighbours && !has(whole, vertex)) continue;
            if (rules.halves_only_fan && !fan.contains(i)) continue;
            tetrahedra[i][at_b] = p;
            tetrahedra.push_back(whole);
            tetrahedra.back()[at_a] = p;
            if (rules.swaps_corners) std::swap(tetrahedra.back()[0], tetrahedra.back()[1]);
            split.parents.push_back(split.parents[i]);
        }
    }

    const auto side = [&](const Tetrahedron& t) {
        double sum = 0, center = 0;
        for (int v : t) {
            sum += heights[v];
            center += n.dot(x[v] - x[vertex]) / 4;
        }
        if (rules.center_in_space)
            center = n.dot((x[t[0]] + x[t[1]] + x[t[2]] + x[t[3]]) / 4 - x[vertex]);
        return sum != 0 ? sum : rules.side_on_plane(center);
    };
    std::vector<MeshFace> faces;
    for (const auto& [face, sharing] : faces_of(split.mesh)) {
        if (sharing.size() != 2 || !rules.opens) continue;
        const Tetrahedron &t1 = tetrahedra[sharing[0]], &t2 = tetrahedra[sharing[1]];
        if (rules.opens_rim) {
            if (!has(t1, vertex) && !has(t2, vertex)) continue;
        } else if (!has(t1, vertex) || !has(t2, vertex) || side(t1) * side(t2) >= 0)
            continue;
        for (int f = 0; f < 4; ++f)
            if (face_of(t1, f) == face) faces.push_back({sharing[0], f});
    }
    const std::vector<VertexOrigin> origins = split.origins;
    const std::vector<int> parents = split.parents;
    split = split_along_faces(split.mesh, faces);
    for (VertexOrigin& origin : split.origins)
        origin = origins[origin.first];
    split.parents = parents;
    return split;
}

} // namespace rigor::cutting
