// SPDX-License-Identifier: MIT
// Correct cutting of tetrahedral meshes (A7.5 to A7.7), with a switch for each mistake.
#pragma once

#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace rigor::cutting {

using Tetrahedron = std::array<int, 4>;
using Face = std::array<int, 3>;

inline Face face_of(const Tetrahedron& t, int f)
{
    Face face = {t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]};
    std::sort(face.begin(), face.end());
    return face;
}

inline int corner_of(const Tetrahedron& t, int vertex)
{
    return static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

inline std::map<Face, std::vector<int>> faces_of(const TetrahedralMesh& mesh)
{
    std::map<Face, std::vector<int>> faces;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int f = 0; f < 4; ++f)
            faces[face_of(mesh.tetrahedra[t], f)].push_back(static_cast<int>(t));
    return faces;
}

/// The corners of all tetrahedra, as a union-find structure: joined corners are one vertex.
class Corners {
public:
    explicit Corners(std::size_t tetrahedra) : above_(4 * tetrahedra)
    {
        std::iota(above_.begin(), above_.end(), 0);
    }
    int find(int i)
    {
        while (above_[i] != i)
            i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(int t1, int c1, int t2, int c2) { above_[find(4 * t1 + c1)] = find(4 * t2 + c2); }

private:
    std::vector<int> above_;
};

/// Renumbers the vertices, one for each set of joined corners.
/// @return the vertex of the original mesh that each one comes from
inline std::vector<int> number_vertices(std::vector<Tetrahedron>& tetrahedra, Corners& corners)
{
    std::map<int, int> number;
    std::vector<int> parents;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int c = 0; c < 4; ++c) {
            const int next = static_cast<int>(parents.size());
            const auto [entry, is_new] =
                number.emplace(corners.find(4 * static_cast<int>(t) + c), next);
            if (is_new) parents.push_back(tetrahedra[t][c]);
            tetrahedra[t][c] = entry->second;
        }
    return parents;
}

/// The vertices that no tetrahedron uses.
inline std::vector<int> unused_vertices(const TetrahedralMesh& mesh)
{
    std::vector<bool> is_used(mesh.vertices.size());
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int v : t)
            is_used[v] = true;
    std::vector<int> unused;
    for (std::size_t v = 0; v < is_used.size(); ++v)
        if (!is_used[v]) unused.push_back(static_cast<int>(v));
    return unused;
}

/// The mesh in which exactly these corners are joined. Without `keeps_unused`, vertices that no
/// tetrahedron uses are left out, which is a mistake.
inline SplitMesh with_joined(const TetrahedralMesh& mesh, Corners& corners,
                             bool keeps_unused = true)
{
    SplitMesh result = {{{}, mesh.tetrahedra}, {}, std::vector<int>(mesh.tetrahedra.size())};
    std::iota(result.parents.begin(), result.parents.end(), 0);
    std::vector<int> parents = number_vertices(result.mesh.tetrahedra, corners);
    if (keeps_unused)
        for (int v : unused_vertices(mesh))
            parents.push_back(v);
    for (int parent : parents) {
        result.mesh.vertices.push_back(mesh.vertices[parent]);
        result.origins.push_back({parent, parent, 0});
    }
    return result;
}

/// The mesh split along the faces for which `is_cut(face)` is true (A7.5).
template <class IsCut>
SplitMesh split_where(const TetrahedralMesh& mesh, IsCut is_cut, bool keeps_unused = true)
{
    Corners corners(mesh.tetrahedra.size());
    for (const auto& [face, sharing] : faces_of(mesh))
        if (sharing.size() == 2 && !is_cut(face))
            for (int v : face)
                corners.join(sharing[0], corner_of(mesh.tetrahedra[sharing[0]], v), sharing[1],
                             corner_of(mesh.tetrahedra[sharing[1]], v));
    return with_joined(mesh, corners, keeps_unused);
}

/// The rules of `split_element` (A7.6); each mistake changes one.
struct ElementRules {
    bool halves_neighbours = true;     // otherwise only tetrahedra at the vertex are split
    bool halves_only_fan = false;      // those around a cut edge that faces connect to the vertex
    bool halves_across_cracks = false; // also those with other vertices at the same places
    bool opens = true;                 // otherwise the mesh is only refined
    bool opens_rim = false;            // separates each tetrahedron at the vertex from all others
    bool halves_in_the_middle = false;
    double nearest_to_an_end = 0;    // the least distance of a new vertex from an end of its edge
    bool swaps_corners = false;      // in one of the two halves
    double snap_distance = 0.05;     // relative to the longest edge
    bool by_own_edges = false;       // the longest edge of the tetrahedra that have the vertex
    bool subtracts_heights = false;  // n·x - n·x_v, whose digits cancel far from the origin
    bool asks_for_both_sides = true; // otherwise it splits even if no vertex is above, or below
    // The side of a tetrahedron on the plane, from the height of its center: positive for above, 0
    // for neither.
    double (*side_on_plane)(double height) = [](double height) { return height >= 0 ? 1.0 : -1.0; };
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
    for (const auto& [a, b] : edges) {
        const double exact = heights[a] / (heights[a] - heights[b]);
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

/// The rules of `virtual_nodes` (A7.7); each mistake changes one.
struct CopyRules {
    bool joins_always = false;       // even if no corner is real in both copies
    bool joins_only_corners = false; // only real corners, not the whole face
    bool on_plane_is_below = false;
    bool first_crack_only = false;
    bool whole_shares = false;  // each copy has the whole volume
    bool corner_shares = false; // a quarter of the volume for each real corner
    bool drops_unused = false;  // vertices that no tetrahedron uses
    bool clips_all = false;     // clips each part by every crack through the tetrahedron
    bool empty_stays = false;   // no crack divides a part without matter
};

/// The share of a tetrahedron's volume on the given sides of all planes. Recursive: an edge that
/// crosses the last plane is cut there, which splits the tetrahedron in two.
///
/// @param piece   barycentric coordinates of the corners, one column per corner
/// @param planes  for each plane the heights of the four original corners, and whether the part is
///                above it
inline double share(const Eigen::Matrix4d& piece,
                    std::vector<std::pair<Eigen::Vector4d, bool>> planes)
{
    if (planes.empty()) return std::abs(piece.determinant());
    const auto [plane, is_above] = planes.back();
    const Eigen::Vector4d h = piece.transpose() * plane * (is_above ? 1 : -1);
    Eigen::Index i = 0, j = 0;
    const double tiny = 1e-13 * plane.cwiseAbs().maxCoeff();
    if (h.maxCoeff(&i) <= tiny) return 0;
    if (h.minCoeff(&j) >= -tiny) {
        planes.pop_back();
        return share(piece, planes);
    }
    const double t = h[i] / (h[i] - h[j]);
    Eigen::Matrix4d first = piece, second = piece;
    first.col(j) = second.col(i) = (1 - t) * piece.col(i) + t * piece.col(j);
    return share(first, planes) + share(second, planes);
}

struct Part {
    Tetrahedron real = {1, 1, 1, 1};
    std::vector<std::pair<Eigen::Vector4d, bool>> planes; // the planes that bound it
};

inline std::vector<Part> parts_of(const CopyRules& rules,
                                  const std::vector<Eigen::Vector4d>& planes)
{
    std::vector<Part> parts(1);
    for (const Eigen::Vector4d& h : planes)
        for (std::size_t i = 0, count = parts.size(); i < count; ++i) {
            Part above = parts[i], below = parts[i];
            for (int c = 0; c < 4; ++c) {
                const bool is_above = rules.on_plane_is_below ? h[c] > 0 : h[c] >= 0;
                (is_above ? below : above).real[c] = 0;
            }
            const Tetrahedron none = {0, 0, 0, 0};
            if (above.real == none || below.real == none) continue;
            if (rules.empty_stays && share(Eigen::Matrix4d::Identity(), parts[i].planes) == 0)
                continue;
            above.planes.push_back({h, true});
            below.planes.push_back({h, false});
            parts[i] = above;
            parts.push_back(below);
        }
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.real > b.real; });
    return parts;
}

inline double share_of(const CopyRules& rules, const Part& part,
                       const std::vector<Eigen::Vector4d>& planes)
{
    const int corners = std::accumulate(part.real.begin(), part.real.end(), 0);
    if (rules.whole_shares) return 1;
    if (rules.corner_shares) return corners / 4.0;
    if (!rules.clips_all) return share(Eigen::Matrix4d::Identity(), part.planes);
    std::vector<std::pair<Eigen::Vector4d, bool>> all;
    for (const Eigen::Vector4d& h : planes) {
        const int own = corner_of(part.real, 1);
        if ((h.array() >= 0).any() && (h.array() < 0).any()) all.push_back({h, h[own] >= 0});
    }
    return share(Eigen::Matrix4d::Identity(), all);
}

inline EmbeddedMesh copies_by(const CopyRules& rules, const TetrahedralMesh& mesh,
                              const std::vector<ElementCrack>& cracks)
{
    std::vector<std::vector<Eigen::Vector4d>> planes(mesh.tetrahedra.size());
    for (const ElementCrack& crack : cracks) {
        Eigen::Vector4d h;
        for (int c = 0; c < 4; ++c)
            h[c] = crack.normal.dot(mesh.vertices[mesh.tetrahedra[crack.tetrahedron][c]] -
                                    crack.point);
        if (rules.first_crack_only && !planes[crack.tetrahedron].empty()) continue;
        planes[crack.tetrahedron].push_back(h);
    }

    EmbeddedMesh result;
    std::vector<std::vector<int>> copies(mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const std::vector<Part> parts = parts_of(rules, planes[t]);
        for (const Part& part : parts) {
            copies[t].push_back(static_cast<int>(result.parents.size()));
            result.parents.push_back(static_cast<int>(t));
            result.real.push_back(part.real);
            result.fractions.push_back(share_of(rules, part, planes[t]));
            result.mesh.tetrahedra.push_back(mesh.tetrahedra[t]);
        }
    }

    Corners corners(result.parents.size());
    for (const auto& [face, sharing] : faces_of(mesh)) {
        if (sharing.size() != 2) continue;
        const Tetrahedron &t1 = mesh.tetrahedra[sharing[0]], &t2 = mesh.tetrahedra[sharing[1]];
        for (int copy1 : copies[sharing[0]])
            for (int copy2 : copies[sharing[1]]) {
                const auto is_real = [&](int v) {
                    return result.real[copy1][corner_of(t1, v)] == 1 &&
                           result.real[copy2][corner_of(t2, v)] == 1;
                };
                const bool is_joined =
                    rules.joins_always || is_real(face[0]) || is_real(face[1]) || is_real(face[2]);
                for (int v : face)
                    if (is_joined && (!rules.joins_only_corners || is_real(v)))
                        corners.join(copy1, corner_of(t1, v), copy2, corner_of(t2, v));
            }
    }
    result.vertex_parents = number_vertices(result.mesh.tetrahedra, corners);
    if (!rules.drops_unused)
        for (int v : unused_vertices(mesh))
            result.vertex_parents.push_back(v);
    for (int parent : result.vertex_parents)
        result.mesh.vertices.push_back(mesh.vertices[parent]);
    return result;
}

} // namespace rigor::cutting
