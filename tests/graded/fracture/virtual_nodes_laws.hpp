// SPDX-License-Identifier: MIT
// The laws of every mesh of virtual nodes, written from the definition.
#pragma once

#include "fracture_laws.hpp"

namespace rigor::testing {

using Cracks = std::vector<ElementCrack>;

inline const Vector3d diagonal = Vector3d(1, 1, 1).normalized();

// A crack along the plane x + y + z = c.
inline ElementCrack corner_cut(int tetrahedron, double c, double sign = 1)
{
    return {tetrahedron, Vector3d(0, c, 0), sign * diagonal};
}

// The same plane through every tetrahedron for whose center `is_cracked` is true.
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

// The sides of a tetrahedron's cracks that each of its corners is on.
inline std::vector<std::vector<bool>> sides_of_corners(const TetrahedralMesh& mesh,
                                                       const Cracks& cracks, int tetrahedron)
{
    std::vector<std::vector<bool>> result(4);
    for (const ElementCrack& crack : cracks)
        if (crack.tetrahedron == tetrahedron)
            for (int c = 0; c < 4; ++c)
                result[c].push_back(
                    crack.normal.dot(corners_of(mesh, tetrahedron)[c] - crack.point) >= 0);
    return result;
}

// Checks the definition of the copies of each tetrahedron, and which of their corners are real.
inline void check_copies(const TetrahedralMesh& mesh, const Cracks& cracks,
                         const EmbeddedMesh& result)
{
    std::vector<int> parents;
    std::vector<Tetrahedron> real;
    for (int t = 0; t < tetrahedron_count(mesh); ++t) {
        const auto sides = sides_of_corners(mesh, cracks, t);
        for (int first = 0; first < 4; ++first) {
            if (std::find(sides.begin(), sides.begin() + first, sides[first]) !=
                sides.begin() + first)
                continue; // its part already has a copy
            Tetrahedron of_copy = {0, 0, 0, 0};
            for (int c = 0; c < 4; ++c)
                of_copy[c] = sides[c] == sides[first];
            parents.push_back(t);
            real.push_back(of_copy);
        }
    }
    REQUIRE_THAT(result.parents, IsExactly(parents));
    REQUIRE_THAT(result.real, IsExactly(real));
}

// Checks the definition of the vertices that copies have in common: these and no others.
inline void check_vertices(const TetrahedralMesh& mesh, const EmbeddedMesh& result)
{
    std::vector<std::vector<int>> copies(mesh.tetrahedra.size());
    for (int i = 0; i < tetrahedron_count(result.mesh); ++i)
        copies[result.parents[i]].push_back(i);

    std::vector<std::array<int, 2>> links;
    for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
        if (sharing.size() != 2) continue;
        const Tetrahedron &t1 = mesh.tetrahedra[sharing[0]], &t2 = mesh.tetrahedra[sharing[1]];
        for (int copy1 : copies[sharing[0]])
            for (int copy2 : copies[sharing[1]]) {
                bool is_joined = false;
                for (int v : face)
                    is_joined |= result.real[copy1][corner_of(t1, v)] == 1 &&
                                 result.real[copy2][corner_of(t2, v)] == 1;
                if (!is_joined) continue;
                for (int v : face)
                    links.push_back({4 * copy1 + corner_of(t1, v), 4 * copy2 + corner_of(t2, v)});
            }
    }
    const std::vector<int> label = groups(4 * result.parents.size(), links);
    std::vector<Tetrahedron> expected(result.parents.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (int c = 0; c < 4; ++c)
            expected[i][c] = label[4 * i + c];
    INFO("vertices of the copies, numbered in the order in which they occur");
    REQUIRE_THAT(canonical(result.mesh.tetrahedra), IsExactly(canonical(expected)));
}

// Embeds cracks, and checks what holds for every EmbeddedMesh: copies stand where their parents do
// and share out their matter.
inline EmbeddedMesh embedded(const TetrahedralMesh& mesh, const Cracks& cracks)
{
    const EmbeddedMesh result = virtual_nodes(mesh, cracks);
    const std::size_t count = result.parents.size();
    REQUIRE(result.mesh.tetrahedra.size() == count);
    REQUIRE(result.real.size() == count);
    REQUIRE(result.fractions.size() == count);
    REQUIRE(result.vertex_parents.size() == result.mesh.vertices.size());
    check_indices(result.mesh);

    std::vector<double> shares(mesh.tetrahedra.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        INFO("a copy, and where its corners come from");
        CAPTURE(i);
        const int parent = result.parents[i];
        REQUIRE(parent >= 0);
        REQUIRE(parent < tetrahedron_count(mesh));
        for (int c = 0; c < 4; ++c) {
            const int v = result.mesh.tetrahedra[i][c], whole = mesh.tetrahedra[parent][c];
            REQUIRE(result.vertex_parents[v] == whole);
            REQUIRE_THAT(result.mesh.vertices[v], IsExactly(mesh.vertices[whole]));
        }
        REQUIRE(result.fractions[i] >= 0);
        REQUIRE(result.fractions[i] <= 1);
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

} // namespace rigor::testing
