// SPDX-License-Identifier: MIT
// The laws that hold for every mesh that comes apart, whatever the method.
#pragma once

#include "fracture_cases.hpp"
#include "support/in_words.hpp"

#include <fmt/format.h>

namespace rigor::testing {

/// Values in ascending order, so that a test compares and prints them at once.
template <class T> std::vector<T> sorted(std::vector<T> values)
{
    std::sort(values.begin(), values.end());
    return values;
}

inline int vertex_count(const TetrahedralMesh& mesh)
{
    return static_cast<int>(mesh.vertices.size());
}

inline int tetrahedron_count(const TetrahedralMesh& mesh)
{
    return static_cast<int>(mesh.tetrahedra.size());
}

inline double volume(const TetrahedralMesh& mesh, std::size_t t)
{
    const Tetrahedron& c = mesh.tetrahedra[t];
    const Vector3d& x = mesh.vertices[c[0]];
    return (mesh.vertices[c[1]] - x).dot((mesh.vertices[c[2]] - x).cross(mesh.vertices[c[3]] - x)) /
           6;
}

inline double volume(const TetrahedralMesh& mesh)
{
    double sum = 0;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        sum += volume(mesh, t);
    return sum;
}

inline Vector3d center(const TetrahedralMesh& mesh, std::size_t t)
{
    Vector3d sum = Vector3d::Zero();
    for (int v : mesh.tetrahedra[t])
        sum += mesh.vertices[v] / 4;
    return sum;
}

/// ∫ x dV, which is the center of mass times the volume.
inline Vector3d first_moment(const TetrahedralMesh& mesh)
{
    Vector3d sum = Vector3d::Zero();
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        sum += volume(mesh, t) * center(mesh, t);
    return sum;
}

inline double size_of(const TetrahedralMesh& mesh)
{
    double size = 1;
    for (const Vector3d& x : mesh.vertices)
        size = std::max(size, x.norm());
    return size;
}

/// The scale of the rounding of a volume.
inline double volume_scale(const TetrahedralMesh& mesh)
{
    return std::pow(size_of(mesh), 3);
}

/// Connected groups of the numbers 0 … size - 1. The lowest number of a group is its label.
inline std::vector<int> groups(std::size_t size, const std::vector<std::array<int, 2>>& links)
{
    std::vector<std::vector<int>> linked(size);
    for (const auto& [a, b] : links) {
        linked[a].push_back(b);
        linked[b].push_back(a);
    }
    std::vector<int> label(size, -1);
    for (std::size_t first = 0; first < size; ++first) {
        std::vector<int> open = {static_cast<int>(first)};
        while (!open.empty()) {
            const int i = open.back();
            open.pop_back();
            if (label[i] >= 0) continue;
            label[i] = static_cast<int>(first);
            open.insert(open.end(), linked[i].begin(), linked[i].end());
        }
    }
    return label;
}

inline int group_count(const std::vector<int>& label)
{
    return static_cast<int>(std::set<int>(label.begin(), label.end()).size());
}

/// A label for each tetrahedron: the lowest number of those that are connected to it by vertices.
inline std::vector<int> piece_labels(const TetrahedralMesh& mesh)
{
    std::map<int, int> last;
    std::vector<std::array<int, 2>> links;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        for (int v : mesh.tetrahedra[t]) {
            if (last.contains(v)) links.push_back({last[v], t});
            last[v] = t;
        }
    return groups(mesh.tetrahedra.size(), links);
}

inline int piece_count(const TetrahedralMesh& mesh)
{
    return group_count(piece_labels(mesh));
}

/// The volumes of the pieces, ascending.
inline std::vector<double> piece_volumes(const TetrahedralMesh& mesh)
{
    std::map<int, double> sums;
    const std::vector<int> label = piece_labels(mesh);
    for (std::size_t t = 0; t < label.size(); ++t)
        sums[label[t]] += volume(mesh, t);
    std::vector<double> result;
    for (const auto& [piece, sum] : sums)
        result.push_back(sum);
    return sorted(result);
}

/// Checks the volumes of the pieces, ascending.
inline void check_piece_volumes(const TetrahedralMesh& mesh, const std::vector<double>& expected,
                                const Tolerance& tolerance)
{
    INFO("the volumes of the pieces [m³], the smallest first");
    REQUIRE_THAT(piece_volumes(mesh), IsClose(expected, tolerance));
}

/// The corners of the tetrahedra, with vertices numbered in the order in which they occur. Two
/// meshes with their tetrahedra in the same order differ only in the numbers of their vertices if
/// these lists are equal.
inline std::vector<Tetrahedron> canonical(const std::vector<Tetrahedron>& tetrahedra)
{
    std::map<int, int> number;
    std::vector<Tetrahedron> result = tetrahedra;
    for (Tetrahedron& t : result)
        for (int& v : t)
            v = number.emplace(v, static_cast<int>(number.size())).first->second;
    return result;
}

/// Checks that two meshes, with their tetrahedra in the same order, agree in which corners are the
/// same vertex. The places of the vertices are not compared.
inline void check_same_vertices(const std::vector<Tetrahedron>& found,
                                const std::vector<Tetrahedron>& expected)
{
    check_count(std::ssize(found), std::ssize(expected), "tetrahedra");
    const std::vector<Tetrahedron> is = canonical(found), should = canonical(expected);
    std::map<int, std::pair<std::size_t, int>> first; // the first corner of each vertex
    for (std::size_t t = 0; t < should.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            const auto [seen, is_new] = first.emplace(should[t][i], std::pair(t, i));
            const auto [s, j] = seen->second;
            check_that(is[t][i] == should[t][i],
                       is_new ? fmt::format("corner {} of tetrahedron {} is a vertex that no "
                                            "earlier corner has",
                                            i, t)
                              : fmt::format("corner {} of tetrahedron {} is the same vertex as "
                                            "corner {} of tetrahedron {}",
                                            i, t, j, s));
        }
}

/// The position of each corner of each tetrahedron.
inline std::vector<std::array<Vector3d, 4>> corners(const TetrahedralMesh& mesh)
{
    std::vector<std::array<Vector3d, 4>> result;
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        result.push_back(corners_of(mesh, t));
    return result;
}

/// Checks that each index is that of a vertex, and that each vertex belongs to a tetrahedron.
inline void check_indices(const TetrahedralMesh& mesh)
{
    std::set<int> used;
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int v : t) {
            check_that(v >= 0 && v < vertex_count(mesh),
                       "each corner of a tetrahedron is the number of a vertex");
            used.insert(v);
        }
    check_count(used.size(), vertex_count(mesh),
                "vertices that belong to a tetrahedron, as many as there are");
}

/// The tetrahedra that have each face, by the vertices of the face.
inline std::map<std::array<int, 3>, std::vector<int>>
tetrahedra_of_faces(const TetrahedralMesh& mesh)
{
    std::map<std::array<int, 3>, std::vector<int>> result;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        for (int f = 0; f < 4; ++f)
            result[face_vertices(mesh.tetrahedra[t], f)].push_back(t);
    return result;
}

/// Links between corners, where corner c of tetrahedron t is 4 t + c. If a face holds, the
/// corners of the same vertex on both sides of it are linked.
template <class Holds>
std::vector<std::array<int, 2>> links_through_faces(const TetrahedralMesh& mesh, Holds holds)
{
    std::vector<std::array<int, 2>> links;
    for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
        if (sharing.size() != 2 || !holds(face)) continue;
        const int t1 = sharing[0], t2 = sharing[1];
        for (int v : face)
            links.push_back({4 * t1 + corner_of(mesh.tetrahedra[t1], v),
                             4 * t2 + corner_of(mesh.tetrahedra[t2], v)});
    }
    return links;
}

/// Labels of the corners of a mesh in which these faces are cut: two corners have the same label if
/// faces that hold connect them.
inline std::vector<int> corners_held_together(const TetrahedralMesh& mesh,
                                              const std::vector<MeshFace>& faces)
{
    std::set<std::array<int, 3>> cut;
    for (const MeshFace& face : faces)
        cut.insert(face_vertices(mesh.tetrahedra[face.tetrahedron], face.face));
    return groups(4 * mesh.tetrahedra.size(),
                  links_through_faces(
                      mesh, [&](const std::array<int, 3>& face) { return !cut.contains(face); }));
}

/// The mesh in which these faces are cut, with a vertex for each group of corners.
inline TetrahedralMesh parted(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const std::vector<int> label = corners_held_together(mesh, faces);
    TetrahedralMesh result = {{}, mesh.tetrahedra};
    result.vertices.resize(static_cast<std::size_t>(group_count(label)));
    std::map<int, int> vertices; // by label
    for (std::size_t c = 0; c < label.size(); ++c) {
        const int next = static_cast<int>(vertices.size());
        const int v = vertices.try_emplace(label[c], next).first->second;
        result.vertices[v] = mesh.vertices[mesh.tetrahedra[c / 4][c % 4]];
        result.tetrahedra[c / 4][c % 4] = v;
    }
    return result;
}

/// Checks that corners have the same vertex exactly if faces that hold connect them.
inline void check_definition(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces,
                             const SplitMesh& result)
{
    const std::vector<int> label = corners_held_together(mesh, faces);
    check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
    std::map<int, int> vertex_of, label_of;
    std::set<int> used;
    bool holds = true, opens = true;
    for (std::size_t c = 0; c < label.size(); ++c) {
        const int v = result.mesh.tetrahedra[c / 4][c % 4];
        holds &= vertex_of.try_emplace(label[c], v).first->second == v;
        opens &= label_of.try_emplace(v, label[c]).first->second == label[c];
        used.insert(mesh.tetrahedra[c / 4][c % 4]);
    }
    check_that(holds, "both sides of a face that holds have the same vertices");
    check_that(opens, "corners have a vertex in common only where faces hold them together");
    const int unused = vertex_count(mesh) - static_cast<int>(used.size());
    check_count(vertex_count(result.mesh), group_count(label) + unused, "vertices");
}

/// Checks that no tetrahedron is inverted, that a face has two sides at most, and that around each
/// vertex the tetrahedra are connected by faces. (`check_surface` checks that no vertex is in the
/// middle of an edge.)
inline void check_conforms(const TetrahedralMesh& mesh)
{
    check_indices(mesh);
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const double V = volume(mesh, t);
        check_that(V > 0, fmt::format("tetrahedron {} has a volume above 0, not {:.3g} m³", t, V));
    }
    for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
        CAPTURE(face[0], face[1], face[2]);
        check_that(sharing.size() <= 2, "at most two tetrahedra have a face in common");
    }
    const std::vector<int> label =
        groups(4 * mesh.tetrahedra.size(),
               links_through_faces(mesh, [](const std::array<int, 3>&) { return true; }));
    check_count(group_count(label), vertex_count(mesh),
                "groups of tetrahedra that faces join around a vertex, one for each vertex");
}

/// The area of all faces that have one tetrahedron, and the area of those that lie on another such
/// face. The latter are the faces that cracks have opened.
struct SurfaceAreas {
    double all = 0, cracks = 0;
};

inline SurfaceAreas surface_areas(const TetrahedralMesh& mesh)
{
    using Key = std::array<std::array<double, 3>, 3>;
    std::map<Key, std::vector<double>> open; // by the positions of their vertices
    for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
        if (sharing.size() != 1) continue;
        Key key;
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis)
                key[i][axis] = mesh.vertices[face[i]][axis];
        std::sort(key.begin(), key.end());
        const Vector3d& a = mesh.vertices[face[0]];
        open[key].push_back((mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).norm() /
                            2);
    }
    SurfaceAreas areas;
    for (const auto& [key, sides] : open) {
        check_that(sides.size() <= 2, "at most two open faces at one place");
        for (double area : sides) {
            areas.all += area;
            if (sides.size() == 2) areas.cracks += area;
        }
    }
    return areas;
}

/// Checks the surface of a mesh that had no cracks before: it is the old surface and both sides of
/// each crack. A vertex in the middle of a neighbor's edge would open more.
inline void check_surface(const TetrahedralMesh& before, const TetrahedralMesh& after)
{
    const SurfaceAreas old = surface_areas(before), now = surface_areas(after);
    const double summands = 4.0 * tetrahedron_count(after); // a face may be on the surface
    INFO("area of the surface without the cracks' sides [m²]");
    REQUIRE_THAT(now.all - now.cracks,
                 IsClose(old.all - old.cracks, Rounding(std::max(256.0, summands), now.all)));
}

/// Checks what holds for every SplitMesh: volume and center are kept, nothing is inverted, and
/// vertices and tetrahedra lie where they come from.
inline void check_matter(const TetrahedralMesh& before, const SplitMesh& split)
{
    const TetrahedralMesh& after = split.mesh;
    check_count(split.parents.size(), tetrahedron_count(after),
                "parents, one for each tetrahedron");
    check_count(split.origins.size(), vertex_count(after), "origins, one for each vertex");
    check_conforms(after);

    const double size = size_of(before);
    for (std::size_t v = 0; v < after.vertices.size(); ++v) {
        INFO("where a vertex is, by its origin");
        CAPTURE(v);
        const auto& [first, second, t] = split.origins[v];
        check_that(std::min(first, second) >= 0 && std::max(first, second) < vertex_count(before),
                   "the origin of a vertex names two vertices of the mesh before");
        check_that(t >= 0 && t <= 1, "the fraction of an origin is between 0 and 1");
        REQUIRE_THAT(after.vertices[v], IsClose(Vector3d((1 - t) * before.vertices[first] +
                                                         t * before.vertices[second]),
                                                Rounding(8, size)));
    }

    std::vector<double> volumes(before.tetrahedra.size(), 0);
    for (std::size_t t = 0; t < after.tetrahedra.size(); ++t) {
        CAPTURE(t);
        check_that(split.parents[t] >= 0 && split.parents[t] < tetrahedron_count(before),
                   "the parent of a tetrahedron is one of the mesh before");
        const Tetrahedron& parent = before.tetrahedra[split.parents[t]];
        for (int v : after.tetrahedra[t]) {
            check_that(corner_of(parent, split.origins[v].first) < 4 &&
                           corner_of(parent, split.origins[v].second) < 4,
                       "the vertices of a tetrahedron come from vertices of its parent");
        }
        volumes[split.parents[t]] += volume(after, t);
    }
    for (std::size_t t = 0; t < volumes.size(); ++t) {
        INFO("volume of what came from a tetrahedron [m³]");
        CAPTURE(t);
        REQUIRE_THAT(volumes[t], IsClose(volume(before, t), Rounding(256, volume_scale(before))));
    }
    INFO("volume times center of mass [m⁴]");
    REQUIRE_THAT(first_moment(after),
                 IsClose(first_moment(before), Rounding(256, volume(before) * size)));
}

/// Checks what holds for a SplitMesh of a mesh without cracks.
inline void check_split(const TetrahedralMesh& before, const SplitMesh& split)
{
    check_matter(before, split);
    check_surface(before, split.mesh);
}

} // namespace rigor::testing
