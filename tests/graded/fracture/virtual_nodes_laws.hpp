// SPDX-License-Identifier: MIT
// The laws of every mesh of virtual nodes, written from the definition.
#pragma once

#include "fracture_laws.hpp"

#include <algorithm>
#include <utility>

namespace rigor::testing {

using Cracks = std::vector<ElementCrack>;

inline const Vector3d diagonal = Vector3d(1, 1, 1).normalized();

// A crack along the plane x + y + z = c, with its normal away from the origin if `sign` is 1.
inline ElementCrack corner_cut(int tetrahedron, double c, double sign = 1)
{
    return {tetrahedron, Vector3d(0, c, 0), sign * diagonal};
}

// Cracks along one plane through every tetrahedron for whose center `is_cracked` is true.
template <class IsCracked>
Cracks plane_through(const TetrahedralMesh& mesh, const Vector3d& point, const Vector3d& normal,
                     IsCracked is_cracked)
{
    Cracks result;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        if (is_cracked(center(mesh, t))) result.push_back({t, point, normal});
    return result;
}

inline Cracks plane_through(const TetrahedralMesh& mesh, const Vector3d& point,
                            const Vector3d& normal)
{
    return plane_through(mesh, point, normal, [](const Vector3d&) { return true; });
}

inline bool separates(const ElementCrack& crack, const Vector3d& a, const Vector3d& b)
{
    return (crack.normal.dot(a - crack.point) >= 0) != (crack.normal.dot(b - crack.point) >= 0);
}

// Checks that each corner is real in one copy, and two corners in the same copy exactly if no crack
// separates them. Copies are in the order of their parents and of their first real corners.
inline void check_copies(const TetrahedralMesh& mesh, const Cracks& cracks,
                         const EmbeddedMesh& result)
{
    std::vector<Tetrahedron> copy_of(mesh.tetrahedra.size(), Tetrahedron{-1, -1, -1, -1});
    std::pair<int, int> last = {-1, 0};
    for (int i = 0; i < static_cast<int>(result.parents.size()); ++i) {
        CAPTURE(i);
        const Tetrahedron& real = result.real[i];
        for (int c = 0; c < 4; ++c) {
            check_that(real[c] == 0 || real[c] == 1, "a corner is real, 1, or virtual, 0");
            if (real[c] == 0) continue;
            check_that(copy_of[result.parents[i]][c] == -1, "a corner is real in one copy only");
            copy_of[result.parents[i]][c] = i;
        }
        const auto first = std::find(real.begin(), real.end(), 1) - real.begin();
        const std::pair place(result.parents[i], static_cast<int>(first));
        check_that(first < 4, "each copy has a real corner");
        check_that(last < place, "the copies of one parent in the order of their first real "
                                 "corner, those of an earlier parent before them");
        last = place;
    }
    for (int t = 0; t < tetrahedron_count(mesh); ++t) {
        const std::array<Vector3d, 4> x = corners_of(mesh, t);
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b) {
                const bool is_cut =
                    std::any_of(cracks.begin(), cracks.end(), [&](const auto& crack) {
                        return crack.tetrahedron == t && separates(crack, x[a], x[b]);
                    });
                CAPTURE(t, a, b);
                check_that(copy_of[t][a] != -1, "each corner is real in some copy");
                check_that((copy_of[t][a] == copy_of[t][b]) == !is_cut,
                           is_cut ? "a crack separates corners a and b: two copies have them"
                                  : "no crack separates corners a and b: one copy has both");
            }
    }
}

// Checks which corners of copies are one vertex. A face joins two copies if one of its corners is
// real in both: then all three corners are the same vertices in both. No other corners share a
// vertex, so there are as many vertices as groups of corners that are joined.
inline void check_vertices(const TetrahedralMesh& mesh, const EmbeddedMesh& result)
{
    std::vector<std::vector<int>> copies(mesh.tetrahedra.size());
    for (int i = 0; i < tetrahedron_count(result.mesh); ++i)
        copies[result.parents[i]].push_back(i);
    std::vector<std::array<int, 2>> joined; // corners of copies
    for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
        if (sharing.size() != 2) continue;
        const Tetrahedron &t1 = mesh.tetrahedra[sharing[0]], &t2 = mesh.tetrahedra[sharing[1]];
        for (int one : copies[sharing[0]])
            for (int other : copies[sharing[1]]) {
                const bool is_joined = std::any_of(face.begin(), face.end(), [&](int v) {
                    return result.real[one][corner_of(t1, v)] +
                               result.real[other][corner_of(t2, v)] ==
                           2;
                });
                if (!is_joined) continue;
                for (int v : face) {
                    const int c1 = corner_of(t1, v), c2 = corner_of(t2, v);
                    CAPTURE(one, other, v);
                    check_that(result.mesh.tetrahedra[one][c1] == result.mesh.tetrahedra[other][c2],
                               "copies that a face joins have its vertices in common");
                    joined.push_back({4 * one + c1, 4 * other + c2});
                }
            }
    }
    check_count(vertex_count(result.mesh), group_count(groups(4 * result.parents.size(), joined)),
                "vertices: copies have one in common only where faces join them");
}

// Embeds cracks, and checks what holds for every EmbeddedMesh: copies stand where their parents do
// and share out their matter.
inline EmbeddedMesh embedded(const TetrahedralMesh& mesh, const Cracks& cracks)
{
    const EmbeddedMesh result = virtual_nodes(mesh, cracks);
    const std::size_t count = result.parents.size();
    check_count(tetrahedron_count(result.mesh), count, "tetrahedra, one for each parent");
    check_count(result.real.size(), count, "rows of `real`, one for each copy");
    check_count(result.fractions.size(), count, "fractions, one for each copy");
    check_count(result.vertex_parents.size(), vertex_count(result.mesh),
                "parents of vertices, one for each vertex");
    check_indices(result.mesh);

    std::vector<double> shares(mesh.tetrahedra.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        CAPTURE(i);
        const int parent = result.parents[i];
        check_that(parent >= 0 && parent < tetrahedron_count(mesh),
                   "the parent of a copy is a tetrahedron of the mesh");
        for (int c = 0; c < 4; ++c) {
            const int v = result.mesh.tetrahedra[i][c], whole = mesh.tetrahedra[parent][c];
            check_that(result.vertex_parents[v] == whole,
                       "a corner of a copy comes from that corner of its parent");
            REQUIRE_THAT(result.mesh.vertices[v], IsExactly(mesh.vertices[whole]));
        }
        check_that(result.fractions[i] >= 0 && result.fractions[i] <= 1,
                   "the share of a copy is between 0 and 1");
        shares[parent] += result.fractions[i];
    }
    for (double share : shares) {
        INFO("sum of the fractions of a tetrahedron's copies");
        REQUIRE_THAT(share, IsClose(1.0, Rounding(64, 1)));
    }
    check_copies(mesh, cracks, result);
    check_vertices(mesh, result);
    return result;
}

// The matter of each piece, ascending [m³].
inline std::vector<double> piece_matter(const TetrahedralMesh& mesh, const EmbeddedMesh& result)
{
    std::map<int, double> sums;
    const std::vector<int> label = piece_labels(result.mesh);
    for (std::size_t i = 0; i < label.size(); ++i)
        sums[label[i]] += result.fractions[i] * volume(mesh, result.parents[i]);
    std::vector<double> matter;
    for (const auto& [piece, sum] : sums)
        matter.push_back(sum);
    return sorted(matter);
}

inline void check_piece_matter(const TetrahedralMesh& mesh, const EmbeddedMesh& result,
                               const std::vector<double>& expected, const Tolerance& tolerance)
{
    INFO("the matter of the pieces [m³], the least first");
    REQUIRE_THAT(piece_matter(mesh, result), IsClose(expected, tolerance));
}

inline void check_shares(const EmbeddedMesh& result, const std::vector<double>& expected,
                         const Tolerance& tolerance)
{
    INFO("the share of the matter in each copy");
    REQUIRE_THAT(result.fractions, IsClose(expected, tolerance));
}

} // namespace rigor::testing
