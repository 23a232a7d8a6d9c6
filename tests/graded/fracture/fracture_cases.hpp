// SPDX-License-Identifier: MIT
// Meshes of tetrahedra, made by hand and at random: the cases of the tests of topic `fracture`.
#pragma once

#include "formulas/fracture.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace rigor::testing {

using Tetrahedron = std::array<int, 4>;

/// The tetrahedron x, y, z ≥ 0, x + y + z ≤ 1.
inline TetrahedralMesh unit_tetrahedron()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
}

/// The unit tetrahedron, and a second one on its face 0, with the vertex 4 at (1, 1, 1).
inline TetrahedralMesh two_tetrahedra()
{
    TetrahedralMesh mesh = unit_tetrahedron();
    mesh.vertices.push_back({1, 1, 1});
    mesh.tetrahedra.push_back({4, 1, 3, 2});
    return mesh;
}

/// The octahedron |x| + |y| + |z| ≤ 1: eight tetrahedra around the vertex 0 in the middle, volume
/// 4/3.
inline TetrahedralMesh octahedron()
{
    TetrahedralMesh mesh = {
        {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
    for (int i = 0; i < 8; ++i) {
        Tetrahedron t = {0, 1 + (i & 1), 3 + (i >> 1 & 1), 5 + (i >> 2 & 1)};
        if (((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 1) std::swap(t[2], t[3]);
        mesh.tetrahedra.push_back(t);
    }
    return mesh;
}

/// The index of the vertex at (i, j, k) in a block of nx ny cubes in each layer.
inline int block_vertex(int nx, int ny, int i, int j, int k)
{
    return i + (nx + 1) * (j + (ny + 1) * k);
}

/// A block of nx × ny × nz unit cubes whose lowest corner is the origin. Each cube has six
/// tetrahedra around its diagonal from the lowest corner to the highest (Kuhn 1960).
inline TetrahedralMesh block(int nx, int ny, int nz)
{
    TetrahedralMesh mesh;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i)
                mesh.vertices.push_back(Vector3d(i, j, k));
    const int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int cell = 0; cell < nx * ny * nz; ++cell)
        for (int way = 0; way < 6; ++way) { // steps along x, y and z in one of six orders
            int place[3] = {cell % nx, cell / nx % ny, cell / (nx * ny)};
            Tetrahedron t = {block_vertex(nx, ny, place[0], place[1], place[2])};
            for (int corner = 1; corner < 4; ++corner) {
                ++place[ways[way][corner - 1]];
                t[corner] = block_vertex(nx, ny, place[0], place[1], place[2]);
            }
            if (way >= 3) std::swap(t[2], t[3]);
            mesh.tetrahedra.push_back(t);
        }
    return mesh;
}

/// The mesh of unit cubes with each vertex moved by so little that nothing is inverted.
inline TetrahedralMesh jiggled(TetrahedralMesh mesh, Random& random)
{
    for (Vector3d& x : mesh.vertices)
        x += 0.1 * random.vector();
    return mesh;
}

/// n tetrahedra in a closed ring around the edge between the vertices 0 and 1. The vertex 2 + i is
/// between the tetrahedra i - 1 and i.
inline TetrahedralMesh ring_around_edge(int n)
{
    TetrahedralMesh mesh = {{{0, 0, -1}, {0, 0, 1}}, {}};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0});
        mesh.tetrahedra.push_back({0, 2 + i, 2 + (i + 1) % n, 1});
    }
    return mesh;
}

inline std::array<Vector3d, 4> corners_of(const TetrahedralMesh& mesh, int t)
{
    const Tetrahedron& c = mesh.tetrahedra[t];
    return {mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]], mesh.vertices[c[3]]};
}

inline std::vector<int> in_order(std::size_t size)
{
    std::vector<int> result(size);
    std::iota(result.begin(), result.end(), 0);
    return result;
}

inline std::vector<int> permutation(Random& random, std::size_t size)
{
    std::vector<int> result = in_order(size);
    for (std::size_t i = size; i > 1; --i)
        std::swap(result[i - 1], result[random_index(random, i)]);
    return result;
}

/// The same solid with its vertices and tetrahedra in another order.
struct Renumbered {
    TetrahedralMesh mesh;
    std::vector<int> vertex;      // new index of each vertex
    std::vector<int> tetrahedron; // new index of each tetrahedron
};

inline Renumbered renumbered(const TetrahedralMesh& mesh, Random& random)
{
    Renumbered result = {mesh, permutation(random, mesh.vertices.size()),
                         permutation(random, mesh.tetrahedra.size())};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        result.mesh.vertices[result.vertex[v]] = mesh.vertices[v];
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int c = 0; c < 4; ++c)
            result.mesh.tetrahedra[result.tetrahedron[t]][c] = result.vertex[mesh.tetrahedra[t][c]];
    return result;
}

inline int corner_of(const Tetrahedron& t, int vertex)
{
    return static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

/// A solid as it was made, or the same solid rotated, moved, scaled and renumbered at random, with
/// the corners of each tetrahedron in another order of the same orientation.
struct Placed : Renumbered {
    Matrix3d R = Matrix3d::Identity();
    Vector3d X = Vector3d::Zero();
    double length = 1; // the new length of 1 m [m]

    explicit Placed(const TetrahedralMesh& made)
        : Renumbered{made, in_order(made.vertices.size()), in_order(made.tetrahedra.size())}
    {
    }
    Placed(const TetrahedralMesh& made, Random& random)
        : Renumbered(renumbered(made, random)), R(random.rotation()), X(random.vector()),
          length(random.uniform(0.5, 2))
    {
        for (Vector3d& x : mesh.vertices)
            x = point(x);
        for (Tetrahedron& t : mesh.tetrahedra) { // a turn of three corners keeps the orientation
            std::rotate(t.begin(), t.begin() + random_index(random, 3), t.end() - 1);
            std::rotate(t.begin() + 1, t.begin() + 1 + random_index(random, 3), t.end());
        }
    }

    Vector3d point(const Vector3d& x) const { return length * (R * x + X); }
    ElementCrack crack(const ElementCrack& made) const
    {
        return {tetrahedron[made.tetrahedron], point(made.point), R * made.normal};
    }
    // the place, in tetrahedron t of the solid as it was made, of the corner that had the vertex v
    int corner(int t, int v) const { return corner_of(mesh.tetrahedra[tetrahedron[t]], vertex[v]); }
};

/// Checks a law for a solid as it was made, and for it placed elsewhere.
template <class Check> void everywhere(const TetrahedralMesh& made, Check check)
{
    check(Placed(made));
    for (Random random : seeds(5))
        check(Placed(made, random));
}

/// The vertices of a face, ascending.
inline std::array<int, 3> face_vertices(const Tetrahedron& t, int face)
{
    std::array<int, 3> result = {t[(face + 1) % 4], t[(face + 2) % 4], t[(face + 3) % 4]};
    std::sort(result.begin(), result.end());
    return result;
}

/// All faces for whose three vertices is_there(x) is true, given from each of their sides.
template <class IsThere>
std::vector<MeshFace> faces_where(const TetrahedralMesh& mesh, IsThere is_there)
{
    std::vector<MeshFace> result;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int f = 0; f < 4; ++f) {
            const auto face = face_vertices(mesh.tetrahedra[t], f);
            if (std::all_of(face.begin(), face.end(),
                            [&](int v) { return is_there(mesh.vertices[v]); }))
                result.push_back({static_cast<int>(t), f});
        }
    return result;
}

} // namespace rigor::testing
